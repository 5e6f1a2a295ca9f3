#pragma once

#include "lang/cursor.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// The insides of `texture`, `finish`, `normal` and `material`. What modifies a given item starts
/// from it.
TextureItem read_texture(Cursor& cursor);
FinishItem read_finish(Cursor& cursor, FinishItem base);
NormalItem read_normal(Cursor& cursor);
MaterialItem read_material(Cursor& cursor);

/// The inside of `#default { ... }`.
void read_default(Cursor& cursor);

/// If the next item is a pigment, finish or normal block: reads it into the texture.
bool read_texture_part(Cursor& cursor, TextureItem& texture);

/// Puts a texture over another one, if there is one, which shows only where the upper lets light
/// through.
TextureItem layer(TextureItem upper, bool has_lower);

}  // namespace meniscus::lang
