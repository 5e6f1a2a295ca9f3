#pragma once

#include "povray/export.hpp"
#include "povray/writer.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// All objects of a scene. `hair` is the gap, or the least overlap of contact, in scene units.
void write_bodies(Writer& writer, const tracer::RenderScene& scene, Model model, double hair);

}  // namespace meniscus::povray
