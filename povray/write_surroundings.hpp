#pragma once

#include "povray/writer.hpp"
#include "scene/scene.hpp"

namespace meniscus::povray {

/// Global settings, camera, sky and lights: all of a scene but its objects.
void write_surroundings(Writer& writer, const scene::Scene& scene);

}  // namespace meniscus::povray
