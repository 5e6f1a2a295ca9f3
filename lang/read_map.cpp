#include "lang/read_map.hpp"

#include <algorithm>

#include "lang/evaluate.hpp"
#include "lang/read_pigment.hpp"

namespace meniscus::lang {
namespace {

void read_color_entry(Cursor& entry, scene::ColorMap& map) {
    auto& session = entry.session();
    const double position = entry.number();
    const auto* node = entry.expression();
    if (!node) {
        map.entries.push_back({position, to_scene_color(session, entry.color())});
        return;
    }
    const auto value = evaluate(session, *node);
    if (!value.get<double>()) {
        map.entries.push_back({position, to_scene_color(session, entry.color())});
        return;
    }
    const auto span = entry.span();
    entry.advance();
    entry.accept_comma();
    if (entry.at_end()) {  // a number as a colour
        map.entries.push_back({position, to_scene_color(session, to_color(value, span))});
        return;
    }
    // the old form: [from, to color A color B]
    map.entries.push_back({position, to_scene_color(session, entry.color())});
    map.entries.push_back({*value.get<double>(), to_scene_color(session, entry.color())});
}

void read_pigment_entry(Cursor& entry, scene::PigmentMap& map, MapItem& item) {
    const double position = entry.number();
    auto pigment = read_pigment(entry, entry.session().default_texture.pigment);
    if (pigment.refusal && !item.refusal) item.refusal = pigment.refusal;
    item.size.add(pigment.size);
    map.entries.push_back(
        {position, std::make_shared<const scene::Pigment>(std::move(pigment.pigment))});
}

}  // namespace

MapItem read_map(Cursor& cursor) {
    MapItem item;
    if (const auto* value = cursor.declared()) {
        if (const auto* map = value->item<MapItem>()) {
            item = *map;
            cursor.advance();
            cursor.expect_end();
            return item;
        }
    }
    scene::ColorMap colors;
    scene::PigmentMap pigments;
    const bool of_colors = cursor.block_word() != "pigment_map";
    while (const auto* entry = cursor.map_entry()) {
        Cursor inner(cursor.session(), entry->items, cursor.span(), cursor.block_word());
        if (of_colors) {
            read_color_entry(inner, colors);
        } else {
            read_pigment_entry(inner, pigments, item);
        }
        inner.expect_end();
        cursor.advance();
        cursor.accept_comma();
    }
    if (colors.entries.empty() && pigments.entries.empty())
        cursor.fail_expected("an entry as [0.5 rgb 1]");
    cursor.expect_end();
    const auto by_position = [](const auto& a, const auto& b) { return a.position < b.position; };
    std::ranges::stable_sort(colors.entries, by_position);
    std::ranges::stable_sort(pigments.entries, by_position);
    if (of_colors) {
        item.map = std::move(colors);
    } else {
        item.map = std::move(pigments);
    }
    return item;
}

}  // namespace meniscus::lang
