#pragma once

#include "compare/regions.hpp"
#include "tracer/options.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::compare {

/// "inside glass", "outside" and "edges" of a scene's exact picture at pixel centres. Edges are a
/// band of one pixel on either side of where the exact picture jumps: neighbours, between which,
/// when the way from the one to the other is halved and halved again down to 1/256 of a pixel, a
/// difference of more than `least_jump` is left. Where the picture does not jump, a pixel's colour
/// does not depend on a rounding error of its ray.
Regions regions_by_jumps(const tracer::RenderScene& scene, const tracer::Options& options,
                         const image::Image& picture);

/// Of a channel, in linear light.
inline constexpr double least_jump = 1e-3;

}  // namespace meniscus::compare
