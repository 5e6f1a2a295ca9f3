#pragma once

#include <cstdint>
#include <vector>

#include "inspect/replay.hpp"
#include "tracer/options.hpp"
#include "tracer/ray_tree.hpp"

namespace meniscus::inspect {

/// One segment of a pixel's ray tree, with what its record implies.
struct Segment {
    tracer::TreeNode node;
    int nesting = 0;  // how many segments led to it
    Listing start;    // its list before the first crossing
    std::vector<Step> steps;
    double way = 0.0;            // scene units in this medium since the last surface
    scene::Rgb absorption{1.0};  // what its medium leaves of the light over that way; at a surface
    scene::Rgb adds{0.0};        // what it adds to the pixel: its own light times the throughput

    bool ends_at_surface() const { return node.end == tracer::TreeNode::End::surface; }
};

/// The ray tree of one pixel's centre.
struct PixelTrace {
    int x = 0, y = 0;
    int width = 0, height = 0;
    tracer::Tree tree = tracer::Tree::whitted;
    tracer::InteriorMode interior = tracer::InteriorMode::sweep;
    std::vector<Segment> segments;  // each behind the one that led to it, depth first
    scene::Rgb color{0.0};          // in the scene's numbers, as all that the segments have
    scene::Rgb light{0.0};          // the same in linear light, as the picture has it
    std::uint64_t leaks = 0;
};

/// Traces pixel (x, y), counted from 0 at the top left. Of the options, the picture's size, the
/// tree and its limits, the interior mode and the seed count.
PixelTrace trace_pixel(const tracer::RenderScene& scene, const Names& names,
                       const tracer::Options& options, int x, int y);

/// The same along any ray.
PixelTrace trace_ray(const tracer::RenderScene& scene, const Names& names,
                     const tracer::Options& options, const geom::Ray& ray);

}  // namespace meniscus::inspect
