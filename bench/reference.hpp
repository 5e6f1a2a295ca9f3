#pragma once

#include "image/image.hpp"
#include "tracer/render.hpp"

namespace meniscus::bench {

/// A picture to measure others against, and how far it may itself be off: it is the mean of two
/// pictures from unlike samples, and half their difference is its own error.
struct Reference {
    image::Image picture;
    int samples = 0;  // a pixel, of both halves together
    int depth = 0;    // segments of a path
    double rmse = 0.0;
    double bias = 0.0;  // of the picture's mean, either way
    bool is_complete = false;
};

/// Renders both halves with all cores, unbiased (Tree::sampled) but for the depth at which paths
/// end. `options` gives the size, the depth and the flag that interrupts.
Reference make_reference(const tracer::RenderScene& scene, tracer::Options options,
                         int samples_of_half);

}  // namespace meniscus::bench
