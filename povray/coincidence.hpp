#pragma once

#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// Of shapes that POV-Ray joins into one, a face that two have in common is both's or neither's to
/// it, by rounding. How much larger each of them must be so that there is no such face: nothing, or
/// a few times `sliver`.
std::vector<double> growth_apart(const tracer::RenderScene& scene, const std::vector<int>& parts,
                                 double sliver);

}  // namespace meniscus::povray
