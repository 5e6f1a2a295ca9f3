#include "lang/evaluate.hpp"
#include "lang/read_object.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_transform.hpp"

namespace meniscus::lang {
namespace {

using scene::Light;

bool read_kind(Cursor& cursor, Light& light) {
    if (cursor.accept("spotlight")) {
        light.kind = Light::Kind::spot;
        light.radius = 30.0;
        light.falloff = 45.0;
    } else if (cursor.accept("cylinder")) {
        light.kind = Light::Kind::cylinder;
        light.radius = 0.75;
        light.falloff = 1.0;
    } else if (cursor.accept("parallel")) {
        light.parallel = cursor.flag_or_true();
    } else if (cursor.accept("shadowless")) {
        light.shadowless = cursor.flag_or_true();
    } else {
        return false;
    }
    return true;
}

bool read_beam(Cursor& cursor, Light& light) {
    if (cursor.accept("point_at")) {
        light.point_at = cursor.vector();
    } else if (cursor.accept("radius")) {
        light.radius = cursor.number();
    } else if (cursor.accept("falloff")) {
        light.falloff = cursor.number();
    } else if (cursor.accept("tightness")) {
        light.tightness = cursor.number();
    } else if (cursor.accept("fade_distance")) {
        light.fade_distance = cursor.number();
    } else if (cursor.accept("fade_power")) {
        light.fade_power = cursor.number();
    } else {
        return false;
    }
    return true;
}

/// area_light and what goes with it: read, and taken as a point light.
bool read_area(Cursor& cursor) {
    const auto span = cursor.span();
    if (cursor.accept("area_light")) {
        cursor.session().warn(
            span, "area lights are not supported here: taken as a point light at its center");
        if (!cursor.expression()) return true;
        cursor.vector();
        cursor.vector();
        cursor.number();
        cursor.number();
    } else if (cursor.accept("adaptive")) {
        cursor.number();
    } else if (cursor.accept("jitter") || cursor.accept("circular") || cursor.accept("orient") ||
               cursor.accept("area_illumination") || cursor.accept("media_attenuation") ||
               cursor.accept("media_interaction")) {
        cursor.flag_or_true();
    } else {
        return false;
    }
    return true;
}

bool read_block(Cursor& cursor, LightItem& item, const geom::Transform& so_far) {
    const auto* block = cursor.block();
    if (!block) return false;
    Cursor inner(cursor.session(), *block, cursor.span());
    if (block->word == "looks_like") {
        const auto* next = inner.block();
        ObjectItem object;
        if (next && is_object_word(next->word)) {
            object = read_object(inner);
        } else if (const auto* value = inner.declared(); value && value->item<ObjectItem>()) {
            object = *value->item<ObjectItem>();
            inner.advance();
        } else {
            inner.fail_expected("an object");
        }
        // it is written around the origin; what was said of the light so far is undone first, as it
        // comes again with the light
        auto place =
            chain_transforms(geom::Transform::translation(so_far.point(item.light.position)),
                             so_far.inverse(), cursor.span());
        ObjectItem placed;
        placed.span = object.span;
        placed.keyword = "union";
        placed.name = object.name;
        placed.depth = object.depth + 1;
        placed.no_shadow = true;
        placed.transform = place;
        placed.body = Union{{std::make_shared<const ObjectItem>(std::move(object))}};
        item.looks_like.push_back(std::make_shared<const ObjectItem>(std::move(placed)));
        inner.expect_end();
    } else if (block->word == "projected_through") {
        if (!item.refusal) item.refusal = Refusal{"projected_through", block->word_span, {}};
        inner.skip_rest();
    } else if (block->word == "photons") {
        cursor.session().warn(block->word_span, "'photons' is read, but does nothing here");
        inner.skip_rest();
    } else {
        return false;
    }
    cursor.advance();
    return true;
}

}  // namespace

ObjectItem read_light(Cursor& cursor, const Span& span) {
    ObjectItem object;
    object.span = span;
    object.keyword = "light_source";
    LightItem item;
    item.span = span;
    const auto* value = cursor.declared();
    if (const auto* other = value ? value->item<ObjectItem>() : nullptr;
        other && std::holds_alternative<LightItem>(other->body)) {
        object = *other;
        object.span = span;
        item = std::get<LightItem>(other->body);
        cursor.advance();
    } else {
        item.light.position = cursor.vector();
        item.light.color = to_light(cursor.session(), cursor.color());
    }
    item.light.location = span.location();
    while (!cursor.at_end()) {
        if (read_transform(cursor, object.transform) || read_kind(cursor, item.light) ||
            read_beam(cursor, item.light) || read_area(cursor) ||
            read_block(cursor, item, object.transform)) {
            continue;
        }
        cursor.fail_unknown();
    }
    for (const auto& part : item.looks_like) object.depth = std::max(object.depth, part->depth + 1);
    object.body = std::move(item);
    return object;
}

}  // namespace meniscus::lang
