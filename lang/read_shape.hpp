#pragma once

#include <optional>

#include "geom/shape.hpp"
#include "lang/cursor.hpp"

namespace meniscus::lang {

/// Reads the arguments of a primitive by its fields and flags, for every shape of geom that has
/// any. Empty if the block's word names none. The cursor stands behind the arguments then.
std::optional<geom::Shape> read_shape(Cursor& cursor);

/// Whether the word names a shape that `read_shape` reads.
bool is_shape_word(std::string_view word);

/// Throws if the shape has no extent where it must have one. `span` is the shape's block.
void check_shape(const geom::Shape& shape, const Span& span);

}  // namespace meniscus::lang
