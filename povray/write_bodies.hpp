#pragma once

#include "povray/export.hpp"
#include "povray/writer.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// All objects of a scene. `hair` is the gap, or the least overlap of contact, and `sliver` what
/// POV-Ray's arithmetic tells apart and its rays do not (coincidence.hpp), in scene units.
/// Returns what the reader should know.
std::vector<std::string> write_bodies(Writer& writer, const tracer::RenderScene& scene, Model model,
                                      double hair, double sliver);

}  // namespace meniscus::povray
