#include <fmt/format.h>

#include <cmath>

#include "lang/read_interior.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_scene.hpp"

namespace meniscus::lang {
namespace {

void read_gamma(Cursor& cursor) {
    auto& session = cursor.session();
    const auto span = cursor.span();
    scene::WorkingSpace space;
    space.is_srgb = cursor.accept("srgb");
    if (!space.is_srgb) space.gamma = cursor.number();
    if (!(space.gamma > 0.0)) throw SourceError(span, "assumed_gamma must be larger than 0");
    if (session.srgb_taken_as && *session.srgb_taken_as != space)
        throw SourceError(span, "assumed_gamma must be stated before the first colour in `srgb`");
    session.states_gamma = true;
    session.scene.settings.working_space = space;
}

int read_trace_level(Cursor& cursor) {
    const auto span = cursor.span();
    const double level = cursor.number();
    if (!(level >= 1.0 && level <= 100000.0))
        throw SourceError(span, fmt::format("max_trace_level cannot be {}", level));
    return static_cast<int>(level);
}

bool read_ignored(Cursor& cursor) {
    if (const auto* block = cursor.block()) {
        if (block->word != "radiosity" && block->word != "photons" && block->word != "subsurface")
            return false;
        cursor.session().warn(block->word_span,
                              fmt::format("'{}' is read, but does nothing here", block->word));
        Cursor inner(cursor.session(), *block, cursor.span());
        inner.skip_rest();
        cursor.advance();
        return true;
    }
    static constexpr std::string_view words[] = {"max_intersections", "number_of_waves",
                                                 "noise_generator",   "hf_gray_16",
                                                 "mm_per_unit",       "irid_wavelength"};
    if (cursor.accept("charset")) {
        cursor.advance();
        return true;
    }
    for (const auto word : words) {
        if (!cursor.accept(word)) continue;
        if (word == "irid_wavelength") {
            cursor.color();
        } else if (cursor.expression()) {
            cursor.number();
        }
        return true;
    }
    return false;
}

}  // namespace

void read_global_settings(Cursor& cursor) {
    auto& session = cursor.session();
    auto& settings = session.scene.settings;
    while (!cursor.at_end()) {
        const auto at = cursor.span();
        if (cursor.accept("assumed_gamma")) {
            read_gamma(cursor);
        } else if (cursor.accept("max_trace_level")) {
            settings.max_trace_level = read_trace_level(cursor);
        } else if (cursor.accept("adc_bailout")) {
            settings.adc_bailout = cursor.number();
        } else if (cursor.accept("ambient_light")) {
            settings.ambient_light = to_light(session, cursor.color());
        } else if (cursor.accept("contact_tolerance")) {
            settings.contact_tolerance = cursor.number();
            if (*settings.contact_tolerance < 0.0)
                throw SourceError(at, "contact_tolerance must not be negative");
        } else if (const auto* block = cursor.block(); block && block->word == "interior") {
            Cursor inner(session, *block, at);
            const auto interior = read_interior(inner, {});
            if (interior.refusal) throw SourceError(at, "the space outside cannot hold this");
            settings.outside = interior.interior;
            settings.outside_location = at.location();
            cursor.advance();
        } else if (!read_ignored(cursor)) {
            cursor.fail_unknown();
        }
    }
}

}  // namespace meniscus::lang
