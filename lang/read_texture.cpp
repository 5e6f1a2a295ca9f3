#include "lang/read_texture.hpp"

#include "lang/evaluate.hpp"
#include "lang/read_interior.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_transform.hpp"

namespace meniscus::lang {
namespace {

/// If the cursor stands at a declared item of this kind, takes it.
template <class Item>
bool take_declared(Cursor& cursor, Item& item) {
    const auto* value = cursor.declared();
    const auto* found = value ? value->item<Item>() : nullptr;
    if (!found) return false;
    item = *found;
    cursor.advance();
    return true;
}

}  // namespace

NormalItem read_normal(Cursor& cursor) {
    NormalItem item;
    if (take_declared(cursor, item)) {
        cursor.skip_rest();
        return item;
    }
    if (cursor.at_end()) return item;
    if (cursor.expression() == nullptr && !is_reserved_next(cursor) &&
        !std::holds_alternative<ast::Function>(cursor.peek()->node)) {
        cursor.fail_unknown();
    }
    item.refusal = Refusal{"normal", cursor.span(), {}};
    cursor.skip_rest();
    return item;
}

bool read_texture_part(Cursor& cursor, TextureItem& texture) {
    const auto* block = cursor.block();
    if (!block) return false;
    const auto span = cursor.span();
    if (block->word == "pigment") {
        Cursor inner(cursor.session(), *block, span);
        texture.pigment = read_pigment(inner, texture.pigment);
    } else if (block->word == "finish") {
        Cursor inner(cursor.session(), *block, span);
        texture.finish = read_finish(inner, texture.finish);
    } else if (block->word == "normal") {
        Cursor inner(cursor.session(), *block, span);
        texture.normal = read_normal(inner);
        if (texture.normal.refusal) texture.normal.refusal->where = block->word_span;
    } else {
        return false;
    }
    cursor.advance();
    return true;
}

TextureItem read_texture(Cursor& cursor) {
    auto texture = cursor.session().default_texture;
    texture.span = cursor.span();
    while (!cursor.at_end()) {
        if (take_declared(cursor, texture)) continue;
        if (const auto* value =
                cursor.declared()) {  // pigments and finishes may stand without their word
            if (const auto* pigment = value->item<PigmentItem>()) {
                texture.pigment = *pigment;
                cursor.advance();
                continue;
            }
            if (const auto* finish = value->item<FinishItem>()) {
                texture.finish = *finish;
                cursor.advance();
                continue;
            }
        }
        // a texture's transformations move its pigment and its normal
        if (read_texture_part(cursor, texture) || read_transform(cursor, texture.transform))
            continue;
        if (is_reserved_next(cursor)) {
            refuse_rest(cursor, texture.refusal);
            continue;
        }
        cursor.fail_unknown();
    }
    return texture;
}

TextureItem layer(TextureItem upper, bool has_lower) {
    if (has_lower) upper.has_layer_below = true;
    return upper;
}

MaterialItem read_material(Cursor& cursor) {
    MaterialItem material;
    while (!cursor.at_end()) {
        if (take_declared(cursor, material)) continue;
        const auto at = cursor.span();
        geom::Transform transform;
        if (read_transform(cursor, transform)) {
            if (material.texture)
                material.texture->transform =
                    chain_transforms(material.texture->transform, transform, at);
            continue;
        }
        if (const auto* block = cursor.block()) {
            Cursor inner(cursor.session(), *block, cursor.span());
            if (block->word == "texture") {
                material.texture = layer(read_texture(inner), material.texture.has_value());
                cursor.advance();
                continue;
            }
            if (block->word == "interior") {
                material.interior =
                    read_interior(inner, material.interior.value_or(InteriorItem{}));
                cursor.advance();
                continue;
            }
        }
        auto interior = material.interior.value_or(InteriorItem{});
        if (read_interior_word(cursor, interior)) {  // the short form
            material.interior = interior;
            material.is_short = true;
            continue;
        }
        if (const auto* block = cursor.block(); block && block->word == "interior_texture") {
            if (!material.interior) material.interior = InteriorItem{};
            refuse_rest(cursor, material.interior->refusal);
            continue;
        }
        cursor.fail_unknown();
    }
    return material;
}

void read_default(Cursor& cursor) {
    auto& texture = cursor.session().default_texture;
    while (!cursor.at_end()) {
        const auto* block = cursor.block();
        if (block && block->word == "texture") {
            Cursor inner(cursor.session(), *block, cursor.span());
            texture = read_texture(inner);
            cursor.advance();
        } else if (block && (block->word == "radiosity" || block->word == "camera")) {
            cursor.advance();
        } else if (!read_texture_part(cursor, texture)) {
            cursor.fail_unknown();
        }
    }
}

}  // namespace meniscus::lang
