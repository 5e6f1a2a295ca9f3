#pragma once

#include "povray/plan.hpp"

namespace meniscus::povray {

/// Throws ExportError, at the object, for what no geometry makes POV-Ray show as it is: the models
/// `contact` and `gap` do not export it.
void require_exact(const tracer::RenderScene& scene, const Plan& plan);

}  // namespace meniscus::povray
