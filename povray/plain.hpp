#pragma once

#include "scene/scene.hpp"

namespace meniscus::povray {

/// The plain model as a scene of our own: no solid has a priority, and of those that overlap the
/// one that a ray entered last is there, as POV-Ray has it.
scene::Scene without_priorities(scene::Scene scene);

}  // namespace meniscus::povray
