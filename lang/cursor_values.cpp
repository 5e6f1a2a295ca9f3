#include <fmt/format.h>

#include <cmath>

#include "grammar/words.hpp"
#include "lang/cursor.hpp"
#include "lang/evaluate.hpp"

namespace meniscus::lang {
namespace {

geom::Vec3 to_vec3(const Vector& v) {
    return {v.at[0], v.size > 1 ? v.at[1] : 0.0, v.size > 2 ? v.at[2] : 0.0};
}

/// Numbers that shape the scene must be numbers.
void check_finite(const geom::Vec3& v, const Span& span) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
        throw SourceError(
            span,
            "this value is not finite: look for a division by zero or a number that is too large");
    }
}

/// The numbers with which the scene computes. Without #version 3.7 and assumed_gamma these go to
/// the picture as they are, which is on the sRGB curve.
scene::WorkingSpace working_space(const Session& session) {
    const bool is_raw = !session.states_gamma && session.version.value_or(3.6) < 3.7;
    return is_raw ? scene::WorkingSpace{.is_srgb = true} : session.scene.settings.working_space;
}

/// `rgb`, `rgbf`, ...: which of the five components the values go to.
void set_components(Session& session, Vector& color, std::string_view word, Vector values) {
    if (word.front() == 's') {
        word.remove_prefix(1);
        const auto space = working_space(session);
        for (std::size_t i = 0; i < 3 && !space.is_srgb; ++i)
            values.at[i] = space.from_light(scene::light_of_srgb(values.at[i]));
        session.srgb_taken_as = space;
    }
    for (std::size_t i = 0; i < 3; ++i) color.at[i] = values.at[i];
    if (word == "rgbf") color.at[3] = values.at[3];
    if (word == "rgbt") color.at[4] = values.at[3];
    if (word == "rgbft") {
        color.at[3] = values.at[3];
        color.at[4] = values.at[4];
    }
}

int channel(std::string_view word) {
    if (word == "red") return 0;
    if (word == "green") return 1;
    if (word == "blue") return 2;
    if (word == "filter") return 3;
    if (word == "transmit" || word == "alpha") return 4;
    return -1;
}

bool is_rgb_word(std::string_view word) { return word.find("rgb") != std::string_view::npos; }

}  // namespace

Value Cursor::value() {
    const auto* node = expression();
    if (!node) fail_expected("a value");
    auto result = evaluate(session_, *node);
    advance();
    accept_comma();
    return result;
}

double Cursor::number() {
    const auto* node = expression();
    if (!node) fail_expected("a number");
    const double result = to_number(evaluate(session_, *node), node->span);
    check_finite({result, 0.0, 0.0}, node->span);
    advance();
    accept_comma();
    return result;
}

bool Cursor::flag() { return is_true(number()); }

bool Cursor::flag_or_true() {
    const auto* node = expression();
    if (!node) return true;
    if (const auto* value = declared(); value && !value->get<double>()) return true;
    return flag();
}

geom::Vec3 Cursor::vector() {
    const auto* node = expression();
    if (!node) fail_expected("a vector");
    const auto result = to_vec3(to_vector(evaluate(session_, *node), node->span));
    check_finite(result, node->span);
    advance();
    accept_comma();
    return result;
}

geom::Vec2 Cursor::vector2() {
    const auto v = vector();
    return {v.x, v.y};
}

std::string Cursor::string() {
    const auto* node = expression();
    if (!node) fail_expected("a string");
    auto result = to_string(evaluate(session_, *node), node->span);
    advance();
    accept_comma();
    return result;
}

Vector Cursor::color() {
    Vector color;
    color.size = 5;
    color.is_color = true;
    while (accept("color") || accept("colour")) {
    }
    const auto first = word();
    if (!first.empty() && is_rgb_word(first) &&
        grammar::classify(first) == grammar::WordClass::color) {
        advance();
        const auto* node = expression();
        if (!node) fail_expected("a color");
        const auto value = evaluate(session_, *node);
        auto components = to_vector(value, node->span);
        set_components(session_, color, first, components);
        advance();
    } else if (channel(first) < 0) {
        const auto* node = expression();
        if (!node) fail_expected("a color");
        color = to_color(evaluate(session_, *node), node->span);
        advance();
    }
    for (auto which = channel(word()); which >= 0; which = channel(word())) {
        advance();
        const auto* node = expression();
        if (!node) fail_expected("a number");
        color.at[static_cast<std::size_t>(which)] =
            to_number(evaluate(session_, *node), node->span);
        advance();
    }
    accept_comma();
    return color;
}

}  // namespace meniscus::lang
