#include "lang/read_pigment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grammar/words.hpp"
#include "lang/evaluate.hpp"
#include "lang/read_map.hpp"
#include "lang/read_transform.hpp"

namespace meniscus::lang {
namespace {

using scene::Color;
using scene::Pigment;

std::shared_ptr<const Pigment> solid(const Color& color) {
    Pigment pigment;
    pigment.pattern = scene::SolidColor{color};
    return std::make_shared<const Pigment>(std::move(pigment));
}

bool starts_color(Cursor& cursor) {
    if (const auto word = cursor.word(); !word.empty())
        return grammar::classify(word) == grammar::WordClass::color;
    if (!cursor.expression()) return false;
    const auto* value = cursor.declared();
    return !value || value->get<double>() || value->get<Vector>();
}

/// The colours or pigments of checker, hexagon and brick; those left out have POV-Ray's defaults.
std::vector<std::shared_ptr<const Pigment>> read_list(Cursor& cursor, PigmentItem& item,
                                                      std::vector<Color> defaults) {
    std::vector<std::shared_ptr<const Pigment>> list;
    item.size = {};
    while (list.size() < defaults.size()) {
        if (const auto* block = cursor.block(); block && block->word == "pigment") {
            Cursor inner(cursor.session(), *block, cursor.span());
            auto part = read_pigment(inner, cursor.session().default_texture.pigment);
            if (part.refusal && !item.refusal) item.refusal = part.refusal;
            item.size.add(part.size);
            list.push_back(std::make_shared<const Pigment>(std::move(part.pigment)));
            cursor.advance();
            cursor.accept_comma();
        } else if (starts_color(cursor)) {
            list.push_back(solid(to_scene_color(cursor.session(), cursor.color())));
        } else {
            break;
        }
    }
    for (auto i = list.size(); i < defaults.size(); ++i) list.push_back(solid(defaults[i]));
    return list;
}

bool read_list_pattern(Cursor& cursor, PigmentItem& item) {
    if (cursor.accept("checker")) {
        auto list = read_list(cursor, item, {{{0, 0, 1}}, {{0, 1, 0}}});
        item.pigment.pattern = scene::Checker{list[0], list[1]};
    } else if (cursor.accept("hexagon")) {
        auto list = read_list(cursor, item, {{{0, 0, 1}}, {{0, 1, 0}}, {{1, 0, 0}}});
        item.pigment.pattern = scene::Hexagon{list[0], list[1], list[2]};
    } else if (cursor.accept("brick")) {
        auto list = read_list(cursor, item, {{{0.5, 0.5, 0.5}}, {{0.6, 0.15, 0.15}}});
        scene::Brick brick;
        brick.mortar = list[0];
        brick.brick = list[1];
        item.pigment.pattern = brick;
    } else {
        return false;
    }
    return true;
}

scene::Gradient* gradient_of(PigmentItem& item) {
    return std::get_if<scene::Gradient>(&item.pigment.pattern);
}

bool read_wave(Cursor& cursor, PigmentItem& item) {
    using Wave = scene::Gradient::Wave;
    static constexpr std::pair<std::string_view, Wave> waves[] = {
        {"ramp_wave", Wave::ramp},   {"triangle_wave", Wave::triangle},
        {"sine_wave", Wave::sine},   {"scallop_wave", Wave::scallop},
        {"cubic_wave", Wave::cubic}, {"poly_wave", Wave::poly}};
    for (const auto& [word, wave] : waves) {
        if (!cursor.accept(word)) continue;
        double exponent = 1.0;
        if (wave == Wave::poly && cursor.expression()) exponent = cursor.number();
        if (auto* gradient = gradient_of(item)) {
            gradient->wave = wave;
            gradient->exponent = exponent;
        }
        return true;
    }
    return false;
}

/// What modifies a pattern that is rendered here.
bool read_modifier(Cursor& cursor, PigmentItem& item) {
    auto* gradient = gradient_of(item);
    auto* brick = std::get_if<scene::Brick>(&item.pigment.pattern);
    if (read_wave(cursor, item)) return true;
    if (cursor.accept("frequency")) {
        const double value = cursor.number();
        if (gradient) gradient->frequency = value;
    } else if (cursor.accept("phase")) {
        const double value = cursor.number();
        if (gradient) gradient->phase = value;
    } else if (cursor.accept("brick_size")) {
        const auto size = cursor.vector();
        if (brick) brick->size = size;
    } else if (cursor.accept("mortar")) {
        const double width = cursor.number();
        if (brick) brick->mortar_width = width;
    } else if (cursor.accept("quick_color") || cursor.accept("quick_colour")) {
        cursor.color();
    } else if (cursor.accept("octaves") || cursor.accept("lambda") || cursor.accept("omega")) {
        cursor.number();
    } else if (cursor.word() == "turbulence") {
        const auto span = cursor.span();
        cursor.advance();
        if (cursor.vector() != geom::Vec3{0.0} && !item.refusal)
            item.refusal = Refusal{"turbulence", span, {}};
    } else {
        return false;
    }
    return true;
}

scene::ColorMap black_to_white() { return {{{0.0, {{0, 0, 0}}}, {1.0, {{1, 1, 1}}}}}; }

void use_map(PigmentItem& item, const MapItem& map, const Span& span) {
    if (!gradient_of(item) && !item.refusal) {
        throw SourceError(span, "a map needs a pattern in front of it, as in gradient x");
    }
    if (map.refusal && !item.refusal) item.refusal = map.refusal;
    item.size = {};  // instead of what was there
    item.size.add(map.size);
    if (auto* gradient = gradient_of(item)) gradient->map = map.map;
}

bool read_declared(Cursor& cursor, PigmentItem& item) {
    const auto* value = cursor.declared();
    if (!value) return false;
    if (const auto* pigment = value->item<PigmentItem>()) {
        item = *pigment;
    } else if (const auto* refusal = value->get<Refusal>()) {
        if (!item.refusal) item.refusal = *refusal;
    } else if (const auto* map = value->item<MapItem>()) {
        use_map(item, *map, cursor.span());
    } else {
        return false;
    }
    cursor.advance();
    return true;
}

}  // namespace

scene::Rgb to_light(const Session&, const Vector& color) {
    return {color.at[0], color.at[1], color.at[2]};
}

Color to_scene_color(const Session& session, const Vector& color) {
    return {to_light(session, color), color.at[3], color.at[4]};
}

bool is_reserved_next(Cursor& cursor) {
    if (const auto* block = cursor.block()) return grammar::is_reserved(block->word);
    return !cursor.word().empty();
}

void refuse_rest(Cursor& cursor, std::optional<Refusal>& refusal) {
    auto span = cursor.span();
    auto word = std::string(cursor.word());
    if (const auto* block = cursor.block()) {
        word = block->word;
        span = block->word_span;
    }
    if (!refusal) refusal = Refusal{std::move(word), span, {}};
    cursor.skip_rest();
}

PigmentItem read_pigment(Cursor& cursor, PigmentItem item) {
    while (!cursor.at_end()) {
        if (read_declared(cursor, item) || read_transform(cursor, item.pigment.transform) ||
            read_list_pattern(cursor, item) || read_modifier(cursor, item)) {
            continue;
        }
        if (cursor.accept("gradient")) {
            scene::Gradient gradient;
            gradient.direction = cursor.vector();
            gradient.map = black_to_white();
            item.pigment.pattern = gradient;
            continue;
        }
        if (const auto* block = cursor.block(); block && is_map_word(block->word)) {
            Cursor inner(cursor.session(), *block, cursor.span());
            use_map(item, read_map(inner), block->word_span);
            cursor.advance();
            continue;
        }
        if (starts_color(cursor)) {
            item.pigment.pattern =
                scene::SolidColor{to_scene_color(cursor.session(), cursor.color())};
            continue;
        }
        if (is_reserved_next(cursor) ||
            std::holds_alternative<ast::Function>(cursor.peek()->node)) {
            refuse_rest(cursor, item.refusal);  // another of POV-Ray's patterns
            continue;
        }
        cursor.fail_unknown();
    }
    const auto& limits = cursor.session().options.limits;
    if (item.size.depth > limits.nesting)
        throw SourceError(cursor.span(), "pigments nested too deep");
    if (item.size.parts > limits.pigment_parts)
        throw SourceError(cursor.span(), fmt::format("this pigment holds more than {:.0f} others",
                                                     limits.pigment_parts));
    return item;
}

}  // namespace meniscus::lang
