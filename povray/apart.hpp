#pragma once

#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// Parts that are no farther apart touch each other. Scene units.
inline double touching_distance(const tracer::RenderScene& scene) { return 1e-7 * scene.size; }

/// Whether two parts surely keep a distance of more than `margin`. False may also mean that it is
/// not known.
bool are_apart(const tracer::Part& a, const tracer::Part& b, double margin);

}  // namespace meniscus::povray
