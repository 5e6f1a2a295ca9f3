#pragma once

#include "lang/cursor.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// The inside of `interior { ... }`, which modifies `base`.
InteriorItem read_interior(Cursor& cursor, InteriorItem base);

/// If the next item is ior, priority, absorption, ...: reads it. These stand in `interior` and in
/// `material`.
bool read_interior_word(Cursor& cursor, InteriorItem& item);

}  // namespace meniscus::lang
