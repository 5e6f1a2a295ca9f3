#pragma once

#include "lang/cursor.hpp"
#include "lang/value.hpp"

namespace meniscus::lang {

/// Reads what may stand on the right of `#declare X =`: an expression, a colour, an array, or any
/// of the scene's blocks.
Value read_value(Cursor& cursor);

}  // namespace meniscus::lang
