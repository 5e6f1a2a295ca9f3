#pragma once

#include "lang/items.hpp"
#include "lang/session.hpp"

namespace meniscus::lang {

/// Takes an object apart into the scene's shapes, solids, textures and lights. Here, and only here,
/// what is not supported is refused.
void add_to_scene(Session& session, const ObjectItem& object);

}  // namespace meniscus::lang
