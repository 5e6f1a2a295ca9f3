#pragma once

#include <string_view>

#include "lang/cursor.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// color_map and pigment_map; and those maps that are only read.
inline bool is_map_word(std::string_view word) {
    return word == "color_map" || word == "colour_map" || word == "pigment_map";
}

/// The inside of a map: `[position value]` entries or a declared map.
MapItem read_map(Cursor& cursor);

}  // namespace meniscus::lang
