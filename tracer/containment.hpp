#pragma once

#include <optional>

#include "geom/placed_shape.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

/// Whether one closed shape lies wholly inside another, by the shapes' own numbers, at least `room`
/// (scene units) from its surface; with no room to touch it counts. None if these two do not allow
/// an answer: there is one where the outer shape is a sphere, box, cylinder or half-space and the
/// inner one finite and made of points and circles (all shapes but curved lathes), and with some
/// room where both are meshes of one surface each. With some room a mesh is
/// taken for the box around it where the outer shape is none.
std::optional<bool> is_contained(const geom::PlacedShape& inner, const geom::PlacedShape& outer,
                                 double room);

/// More than what any rounding or tolerance of the scene could be about, in scene units.
double room_to_spare(const RenderScene& scene);

}  // namespace meniscus::tracer
