#pragma once

#include "compare/regions.hpp"
#include "tracer/options.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::compare {

/// "inside glass", "outside" and "edges" of a scene's exact picture at pixel centres. An edge is
/// where the ray trees of neighbours differ: a branch of weight `least_weight` or more that meets
/// another face in the one than in the other, or is not there. So edges seen through glass count
/// too, however faint their contrast. Edges of textures and shadows are found by the picture's
/// contrast.
Regions regions_by_ray_trees(const tracer::RenderScene& scene, const tracer::Options& options,
                             const image::Image& picture);

/// A branch of less weight is less than a hundredth of its pixel.
inline constexpr double least_weight = 0.01;

}  // namespace meniscus::compare
