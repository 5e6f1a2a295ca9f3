#pragma once

#include <string>
#include <vector>

#include "povray/plan.hpp"

namespace meniscus::povray {

/// Throws ExportError, at the object, for what no geometry makes POV-Ray show as it is: the models
/// `contact` and `gap` do not export it.
void require_exact(const tracer::RenderScene& scene, const Plan& plan);

/// What may be another picture in POV-Ray, in any model: media without an end that absorb, of which
/// POV-Ray knows nothing along rays to the sky. A line each, as file:line: words.
std::vector<std::string> doubts(const tracer::RenderScene& scene, const Plan& plan);

}  // namespace meniscus::povray
