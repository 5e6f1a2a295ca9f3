#pragma once

#include "lang/cursor.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// The inside of `pigment { ... }`, which modifies `base`.
PigmentItem read_pigment(Cursor& cursor, PigmentItem base);
/// The inside of `color_map { ... }` or `pigment_map { ... }`.
MapItem read_map(Cursor& cursor);

/// A colour as the scene's numbers mean it.
scene::Color to_scene_color(const Session& session, const Vector& color);
scene::Rgb to_light(const Session& session, const Vector& color);

/// Notes what is not supported, if nothing was noted before, and passes over the rest of the block.
void refuse_rest(Cursor& cursor, std::optional<Refusal>& refusal);
/// Whether the next item is a word or block of the language (rather than an unknown one).
bool is_reserved_next(Cursor& cursor);

}  // namespace meniscus::lang
