#pragma once

#include "scene/scene.hpp"

namespace meniscus::oracle {

/// A pigment's colour at a point of the frame that it is used in: solid colours, checkers and
/// gradients with colour maps.
scene::Color color_at(const scene::Pigment& pigment, const geom::Vec3& p);

/// What a ray that goes on for ever sees.
scene::Rgb sky(const scene::Scene& scene, const geom::Vec3& direction);

}  // namespace meniscus::oracle
