#include "lang/read_interior.hpp"

#include "lang/read_pigment.hpp"

namespace meniscus::lang {
namespace {

scene::Rgb rgb(const Vector& color) { return {color.at[0], color.at[1], color.at[2]}; }

double not_negative(Cursor& cursor, std::string_view what) {
    const auto span = cursor.span();
    const double value = cursor.number();
    if (value < 0.0) throw SourceError(span, std::string(what) + " must not be negative");
    return value;
}

}  // namespace

bool read_interior_word(Cursor& cursor, InteriorItem& item) {
    auto& interior = item.interior;
    if (cursor.accept("ior")) {
        const auto span = cursor.span();
        interior.ior = cursor.number();
        interior.states_ior = true;
        if (interior.ior <= 0.0) throw SourceError(span, "ior must be larger than 0");
    } else if (cursor.accept("priority")) {
        interior.priority = cursor.number();
        interior.states_priority = true;
    } else if (cursor.accept("absorption")) {
        const auto span = cursor.span();
        interior.absorption = rgb(cursor.color());
        for (int i = 0; i < 3; ++i) {
            if (!(interior.absorption[i] >= 0.0))
                throw SourceError(span, "absorption must not be negative");
        }
    } else if (cursor.accept("fade_distance")) {
        interior.fade.distance = not_negative(cursor, "fade_distance");
    } else if (cursor.accept("fade_power")) {
        interior.fade.power = not_negative(cursor, "fade_power");
    } else if (cursor.accept("fade_color") || cursor.accept("fade_colour")) {
        interior.fade.color = rgb(cursor.color());
    } else if (cursor.accept("caustics")) {
        interior.caustics = cursor.number();
    } else if (cursor.word() == "dispersion") {
        const auto span = cursor.span();
        cursor.advance();
        if (cursor.number() != 1.0 && !item.refusal) item.refusal = Refusal{"dispersion", span, {}};
    } else if (cursor.accept("dispersion_samples")) {
        cursor.number();
    } else {
        return false;
    }
    return true;
}

InteriorItem read_interior(Cursor& cursor, InteriorItem item) {
    while (!cursor.at_end()) {
        if (read_interior_word(cursor, item)) continue;
        const auto* value = cursor.declared();
        if (const auto* other = value ? value->item<InteriorItem>() : nullptr) {
            item = *other;
            cursor.advance();
            continue;
        }
        if (const auto* block = cursor.block(); block && block->word == "media") {
            if (!item.refusal)
                item.refusal = Refusal{"media", block->word_span,
                                       "for a clear colored medium write absorption rgb <...>"};
            cursor.advance();
            continue;
        }
        if (value && value->get<Refusal>()) {
            item.refusal = *value->get<Refusal>();
            cursor.advance();
            continue;
        }
        cursor.fail_unknown();
    }
    return item;
}

}  // namespace meniscus::lang
