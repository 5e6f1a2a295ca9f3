#pragma once

#include "lang/cursor.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// Whether a block of this word is an object, a union or a light (supported or not).
bool is_object_word(std::string_view word);

/// Reads the block that the cursor stands at, and moves on. The word must be an object's.
ObjectItem read_object(Cursor& cursor);

/// `light_source { ... }`, from its inside.
ObjectItem read_light(Cursor& cursor, const Span& span);

}  // namespace meniscus::lang
