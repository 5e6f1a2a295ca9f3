#pragma once

#include "lang/cursor.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// The inside of `camera { ... }`.
CameraItem read_camera(Cursor& cursor);

/// The camera after look_at, angle and all transformations, by POV-Ray's rules.
scene::Camera resolve(const CameraItem& camera, const Span& span);

}  // namespace meniscus::lang
