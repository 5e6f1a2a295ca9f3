#pragma once

#include "scene/texture.hpp"

namespace meniscus::tracer {

/// The colour of a pigment at a point of the frame that its user gives it (its own transform is
/// taken into account here).
scene::Color evaluate(const scene::Pigment& pigment, const geom::Vec3& point);

/// The colour of a texture at a point of the world.
scene::Color evaluate(const scene::Texture& texture, const geom::Vec3& point);

}  // namespace meniscus::tracer
