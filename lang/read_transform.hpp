#pragma once

#include "geom/transform.hpp"
#include "lang/cursor.hpp"

namespace meniscus::lang {

/// If the next item is translate, rotate, scale, matrix or transform: reads it, appends it to
/// `transform`, and says so.
bool read_transform(Cursor& cursor, geom::Transform& transform);

/// `first`, then `next`; throws SourceError where the numbers run out.
geom::Transform chain_transforms(const geom::Transform& first, const geom::Transform& next,
                                 const Span& span);

/// The inside of `transform { ... }`.
TransformItem read_transform_block(Cursor& cursor);

}  // namespace meniscus::lang
