#include "lang/read_object.hpp"

#include <algorithm>
#include <array>

#include "lang/evaluate.hpp"
#include "lang/read_interior.hpp"
#include "lang/read_mesh.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_shape.hpp"
#include "lang/read_texture.hpp"
#include "lang/read_transform.hpp"

namespace meniscus::lang {
namespace {

constexpr auto csg_advice =
    "say it with overlapping solids and priorities instead:\n"
    "        union, merge:  the same medium and priority on both parts\n"
    "            sphere { 0, 1  material { ior 1.5 priority 1 } }\n"
    "            box { 0, 1  material { ior 1.5 priority 1 } }\n"
    "        difference:    the part cut away is a solid of higher priority, with the ior of the "
    "outside\n"
    "            box { -1, 1  material { ior 1.5 priority 1 } }\n"
    "            sphere { y, 0.7  material { ior 1 priority 2 } }\n"
    "        intersection:  the outside of the second part, as `inverse`, takes away from the "
    "first\n"
    "            sphere { -0.5*x, 1  material { ior 1.5 priority 1 } }\n"
    "            sphere { 0.5*x, 1 inverse  material { ior 1 priority 2 } }";

constexpr std::array unsupported_shapes = {
    "bicubic_patch", "blob",       "cubic",        "height_field",   "isosurface", "julia_fractal",
    "ovus",          "parametric", "poly",         "polynomial",     "prism",      "quadric",
    "quartic",       "sor",        "sphere_sweep", "superellipsoid", "text",       "light_group"};

bool is_csg(std::string_view word) {
    return word == "difference" || word == "intersection" || word == "merge";
}

bool is_unsupported(std::string_view word) {
    return is_csg(word) || std::ranges::find(unsupported_shapes, word) != unsupported_shapes.end();
}

void transform_object(ObjectItem& object, const geom::Transform& transform, const Span& span) {
    object.transform = chain_transforms(object.transform, transform, span);
    if (object.texture) {
        object.texture->transform = chain_transforms(object.texture->transform, transform, span);
    }
}

TextureItem& own_texture(Session& session, ObjectItem& object) {
    if (!object.texture) object.texture = session.default_texture;
    object.clear = false;
    return *object.texture;
}

void set_material(ObjectItem& object, const MaterialItem& material) {
    if (material.texture) {
        object.texture = material.texture;
        object.clear = false;
    } else if (material.is_short && !object.texture) {
        object.clear = true;
    }
    if (material.interior) object.interior = material.interior;
}

bool read_flag(Cursor& cursor, ObjectItem& object) {
    static constexpr std::pair<std::string_view, bool ObjectItem::*> flags[] = {
        {"no_shadow", &ObjectItem::no_shadow},
        {"no_image", &ObjectItem::no_image},
        {"no_reflection", &ObjectItem::no_reflection},
        {"hollow", &ObjectItem::hollow},
        {"double_illuminate", &ObjectItem::double_illuminate}};
    for (const auto& [word, member] : flags) {
        if (!cursor.accept(word)) continue;
        object.*member = cursor.flag_or_true();
        return true;
    }
    if (cursor.accept("inverse")) {
        object.inverse = !object.inverse;
        return true;
    }
    // words about how POV-Ray finds or stores things: nothing to do
    static constexpr std::string_view ignored[] = {"hierarchy", "no_radiosity", "split_union",
                                                   "cutaway_textures", "smooth"};
    for (const auto word : ignored) {
        if (cursor.accept(word)) {
            cursor.flag_or_true();
            return true;
        }
    }
    return false;
}

bool read_modifier_block(Cursor& cursor, ObjectItem& object) {
    const auto* block = cursor.block();
    if (!block) return false;
    auto& session = cursor.session();
    const auto word = block->word;
    const auto span = cursor.span();
    if (word == "pigment" || word == "finish" || word == "normal")
        return read_texture_part(cursor, own_texture(session, object));
    Cursor inner(session, *block, span);
    if (word == "texture") {
        object.texture = layer(read_texture(inner), bool(object.texture));
        object.clear = false;
    } else if (word == "interior") {
        object.interior = read_interior(inner, object.interior.value_or(InteriorItem{}));
    } else if (word == "material") {
        set_material(object, read_material(inner));
    } else if (word == "clipped_by" || word == "interior_texture") {
        if (!object.refusal) object.refusal = Refusal{std::string(word), block->word_span, {}};
        inner.skip_rest();
    } else if (word == "photons" || word == "radiosity") {
        session.warn(block->word_span,
                     "'" + std::string(word) + "' is read, but does nothing here");
        inner.skip_rest();
    } else if (word == "bounded_by") {
        inner.skip_rest();
    } else {
        return false;
    }
    cursor.advance();
    return true;
}

bool read_modifier(Cursor& cursor, ObjectItem& object) {
    const auto at = cursor.span();
    geom::Transform transform;
    if (read_transform(cursor, transform)) {
        transform_object(object, transform, at);
        return true;
    }
    if (read_flag(cursor, object) || read_modifier_block(cursor, object)) return true;
    if (cursor.word() == "uv_mapping" || cursor.word() == "sturm") {
        const bool refused = cursor.word() == "uv_mapping";
        const auto span = cursor.span();
        cursor.advance();
        cursor.flag_or_true();
        if (refused && !object.refusal) object.refusal = Refusal{"uv_mapping", span, {}};
        return true;
    }
    const auto* value = cursor.declared();
    if (!value) return false;
    if (const auto* texture = value->item<TextureItem>()) {
        object.texture = layer(*texture, bool(object.texture));
    } else if (const auto* material = value->item<MaterialItem>()) {
        set_material(object, *material);
    } else {
        return false;
    }
    cursor.advance();
    return true;
}

void read_members(Cursor& cursor, ObjectItem& object) {
    Union members;
    for (;;) {
        const auto* block = cursor.block();
        if (!block || !is_object_word(block->word)) break;
        auto member = read_object(cursor);
        object.depth = std::max(object.depth, member.depth + 1);
        members.members.push_back(std::make_shared<const ObjectItem>(std::move(member)));
    }
    object.body = std::move(members);
}

/// `object { X ... }`: a copy of a declared object, or of one written there.
ObjectItem read_copy(Cursor& cursor, const Span& span) {
    if (const auto* value = cursor.declared()) {
        if (const auto* object = value->item<ObjectItem>()) {
            auto copy = *object;
            copy.span = span;
            cursor.advance();
            return copy;
        }
        if (const auto* refusal = value->get<Refusal>()) {
            ObjectItem copy;
            copy.body = *refusal;
            copy.span = span;
            cursor.advance();
            return copy;
        }
    }
    const auto* block = cursor.block();
    if (block && is_object_word(block->word)) return read_object(cursor);
    if (block || cursor.declared()) cursor.fail_unknown();
    if (const auto* node = cursor.expression())
        evaluate(cursor.session(), *node);  // an unknown name says so
    cursor.fail_expected("an object");
}

ObjectItem read_body(Cursor& cursor, const Span& span) {
    const auto word = cursor.block_word();
    if (word == "light_source") return read_light(cursor, span);
    if (word == "object") return read_copy(cursor, span);
    ObjectItem object;
    object.span = span;
    object.keyword = word;
    if (word == "union") {
        read_members(cursor, object);
    } else if (word == "mesh") {
        std::visit([&](auto&& mesh) { object.body = std::move(mesh); },
                   read_mesh(cursor, cursor.span()));
    } else if (is_unsupported(word)) {
        object.body = Refusal{std::string(word), span, is_csg(word) ? csg_advice : ""};
        cursor.skip_rest();
    } else {
        auto shape = read_shape(cursor);
        check_shape(*shape, span);
        object.body = std::move(*shape);
    }
    return object;
}

}  // namespace

bool is_object_word(std::string_view word) {
    return is_shape_word(word) || word == "union" || word == "object" || word == "light_source" ||
           is_unsupported(word);
}

ObjectItem read_object(Cursor& cursor) {
    const auto* block = cursor.block();
    const auto span = cursor.span();
    Cursor inner(cursor.session(), *block, span);
    auto object = read_body(inner, block->word_span);
    while (!inner.at_end()) {
        if (read_modifier(inner, object)) continue;
        if (std::holds_alternative<Union>(object.body)) {  // a member that stands behind a modifier
            const auto* next = inner.block();
            if (next && is_object_word(next->word)) {
                throw SourceError(next->word_span,
                                  "the members of a union stand in front of what modifies it");
            }
        }
        inner.fail_unknown();
    }
    if (object.depth > cursor.session().options.limits.nesting)
        throw SourceError(span, "objects nested too deep");
    cursor.advance();
    return object;
}

}  // namespace meniscus::lang
