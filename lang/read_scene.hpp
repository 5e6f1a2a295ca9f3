#pragma once

#include "lang/cursor.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// Carries out a whole file: its objects, lights, camera and settings go into the session's scene.
void read_scene(Cursor& cursor);

SkyItem read_sky_sphere(Cursor& cursor);

/// The inside of `global_settings { ... }`.
void read_global_settings(Cursor& cursor);

[[noreturn]] void fail_unknown_object(Session& session, std::string_view word, const Span& span);

}  // namespace meniscus::lang
