#pragma once

#include "scene/scene.hpp"

namespace meniscus::tracer {

/// The light of the sky in a direction, through the medium that fills the space up to it. The sky
/// is at infinity: a medium out there that absorbs leaves nothing of it.
scene::Rgb sky(const scene::Scene& scene, const geom::Vec3& direction,
               const scene::Interior& around);

}  // namespace meniscus::tracer
