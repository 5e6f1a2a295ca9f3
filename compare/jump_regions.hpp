#pragma once

#include "compare/regions.hpp"
#include "tracer/options.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::compare {

/// "inside glass", "outside" and "edges" of a scene's exact picture at pixel centres. Edges are a
/// band one pixel wide along the exact picture's jumps: pixels from whose centre a jump is less
/// than half a pixel to the left, right, up or down. A jump is where, when the way is halved and
/// halved again to the side of the greater difference, down to 1/512 of a pixel, more than
/// `least_jump` is left. Elsewhere a pixel's colour does not depend on a rounding error of its ray.
Regions regions_by_jumps(const tracer::RenderScene& scene, const tracer::Options& options,
                         const image::Image& picture);

/// Of a channel, in linear light. Were one pixel in 400 to see the wrong side of jumps as small as
/// this, their part in an RMSE would be 5e-5.
inline constexpr double least_jump = 1e-3;

}  // namespace meniscus::compare
