#include <cmath>

#include "lang/evaluate.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_texture.hpp"

namespace meniscus::lang {
namespace {

scene::Rgb rgb(const Vector& color) { return {color.at[0], color.at[1], color.at[2]}; }

/// Which amounts were given as albedo, to be resolved when the exponents are known.
struct Albedo {
    bool diffuse = false, phong = false, specular = false;

    void resolve(scene::Finish& finish) const {
        if (diffuse) finish.diffuse *= (finish.brilliance + 1.0) / 2.0;
        if (phong) finish.phong *= (finish.phong_size + 1.0) / 2.0;
        if (specular) {
            const double e = 1.0 / finish.roughness;
            finish.specular *= (e + 2.0) / (4.0 * (2.0 - std::pow(2.0, -e / 2.0)));
        }
    }
};

void read_reflection_block(Cursor& cursor, scene::Reflection& reflection) {
    reflection = {};
    reflection.max = rgb(cursor.color());
    bool has_min = false;
    if (cursor.expression() || cursor.word().starts_with("rgb") || cursor.word() == "color") {
        has_min = true;
        reflection.min = reflection.max;
        reflection.max = rgb(cursor.color());
    }
    while (!cursor.at_end()) {
        if (cursor.accept("fresnel")) {
            reflection.fresnel = cursor.flag_or_true();
        } else if (cursor.accept("falloff")) {
            reflection.falloff = cursor.number();
        } else if (cursor.accept("exponent")) {
            reflection.exponent = cursor.number();
        } else if (cursor.accept("metallic")) {
            reflection.metallic = cursor.expression() ? cursor.number() : 1.0;
        } else {
            cursor.fail_unknown();
        }
    }
    if (!has_min && !reflection.fresnel) reflection.min = reflection.max;
}

bool read_block(Cursor& cursor, FinishItem& item) {
    const auto* block = cursor.block();
    if (!block) return false;
    Cursor inner(cursor.session(), *block, cursor.span());
    if (block->word == "reflection") {
        read_reflection_block(inner, item.finish.reflection);
    } else if (block->word == "irid") {
        cursor.session().warn(block->word_span, "'irid' is read, but does nothing here");
        item.finish.irid = true;
        inner.skip_rest();
    } else if (block->word == "subsurface") {
        if (!item.refusal) item.refusal = Refusal{"subsurface", block->word_span, {}};
        inner.skip_rest();
    } else {
        return false;
    }
    cursor.advance();
    return true;
}

/// The second number of `diffuse`: light that thin surfaces let through to their far side.
void read_far_side(Cursor& cursor) {
    const auto span = cursor.span();
    if (cursor.number() != 0.0)
        cursor.session().warn(span, "light from the far side of a surface is not supported here");
}

bool read_old_refraction(Cursor& cursor, FinishItem& item) {
    const auto span = cursor.span();
    auto& session = cursor.session();
    if (cursor.accept("ior")) {
        item.ior = cursor.number();
        if (*item.ior <= 0.0) throw SourceError(span, "ior must be larger than 0");
        session.warn(span, "'ior' in a finish is old: write it in 'interior'");
    } else if (cursor.accept("caustics")) {
        item.caustics = cursor.number();
    } else if (cursor.accept("refraction")) {
        cursor.number();
        session.warn(
            span,
            "'refraction' in a finish is old and does nothing: an 'ior' in 'interior' refracts");
    } else if (cursor.accept("fade_distance") || cursor.accept("fade_power")) {
        cursor.number();
    } else {
        return false;
    }
    return true;
}

}  // namespace

FinishItem read_finish(Cursor& cursor, FinishItem item) {
    auto& finish = item.finish;
    Albedo albedo;
    while (!cursor.at_end()) {
        const auto at = cursor.span();
        if (const auto* value = cursor.declared()) {
            if (const auto* other = value->item<FinishItem>()) {
                item = *other;
                cursor.advance();
                continue;
            }
        }
        if (read_block(cursor, item) || read_old_refraction(cursor, item)) continue;
        if (cursor.accept("ambient")) {
            finish.ambient = rgb(cursor.color());
        } else if (cursor.accept("emission")) {
            finish.emission = rgb(cursor.color());
        } else if (cursor.accept("diffuse")) {
            albedo.diffuse = cursor.accept("albedo");
            finish.diffuse = cursor.number();
            if (cursor.expression()) read_far_side(cursor);
        } else if (cursor.accept("brilliance")) {
            finish.brilliance = cursor.number();
        } else if (cursor.accept("phong")) {
            albedo.phong = cursor.accept("albedo");
            finish.phong = cursor.number();
        } else if (cursor.accept("phong_size")) {
            finish.phong_size = cursor.number();
        } else if (cursor.accept("specular")) {
            albedo.specular = cursor.accept("albedo");
            finish.specular = cursor.number();
        } else if (cursor.accept("roughness")) {
            finish.roughness = cursor.number();
            if (finish.roughness == 0.0) throw SourceError(at, "roughness must not be 0");
        } else if (cursor.accept("metallic")) {
            finish.metallic = cursor.expression() ? cursor.number() : 1.0;
        } else if (cursor.accept("reflection")) {
            finish.reflection.min = finish.reflection.max = rgb(cursor.color());
        } else if (cursor.accept("reflection_exponent")) {
            finish.reflection.exponent = cursor.number();
        } else if (cursor.accept("crand")) {
            finish.crand = cursor.number();
        } else if (cursor.accept("conserve_energy")) {
            finish.conserve_energy = cursor.flag_or_true();
        } else if (cursor.accept("use_alpha")) {
            cursor.flag_or_true();
        } else {
            cursor.fail_unknown();
        }
    }
    albedo.resolve(finish);
    return item;
}

}  // namespace meniscus::lang
