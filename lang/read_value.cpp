#include "lang/read_value.hpp"

#include <fmt/format.h>

#include "grammar/words.hpp"
#include "lang/evaluate.hpp"
#include "lang/read_array.hpp"
#include "lang/read_camera.hpp"
#include "lang/read_interior.hpp"
#include "lang/read_map.hpp"
#include "lang/read_object.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_scene.hpp"
#include "lang/read_texture.hpp"
#include "lang/read_transform.hpp"

namespace meniscus::lang {
namespace {

/// Textures that follow each other are layers of one.
Value read_layers(Cursor& cursor) {
    std::optional<TextureItem> texture;
    for (;;) {
        const auto* block = cursor.block();
        if (!block || block->word != "texture") break;
        Cursor inner(cursor.session(), *block, cursor.span());
        texture = layer(read_texture(inner), texture.has_value());
        cursor.advance();
    }
    return make_item(std::move(*texture));
}

Value read_block(Cursor& cursor, const ast::Block& block) {
    auto& session = cursor.session();
    const auto word = block.word;
    if (word == "texture") return read_layers(cursor);
    if (is_object_word(word)) return make_item(read_object(cursor));

    Cursor inner(session, block, cursor.span());
    const auto done = [&](Value value) {
        inner.expect_end();
        cursor.advance();
        return value;
    };
    if (word == "pigment")
        return done(make_item(read_pigment(inner, session.default_texture.pigment)));
    if (word == "finish")
        return done(make_item(read_finish(inner, session.default_texture.finish)));
    if (word == "normal") return done(make_item(read_normal(inner)));
    if (word == "material") return done(make_item(read_material(inner)));
    if (word == "interior") return done(make_item(read_interior(inner, {})));
    if (word == "transform") return done(make_item(read_transform_block(inner)));
    if (is_map_word(word)) return done(make_item(read_map(inner)));
    if (word == "camera") return done(make_item(read_camera(inner)));
    if (word == "sky_sphere") return done(make_item(read_sky_sphere(inner)));
    if (grammar::is_reserved(word)) {
        inner.skip_rest();
        cursor.advance();
        return {Refusal{std::string(word), block.word_span, {}}};
    }
    fail_unknown_object(session, block.word, block.word_span);
}

bool starts_color(Cursor& cursor) {
    const auto word = cursor.word();
    return !word.empty() && grammar::classify(word) == grammar::WordClass::color;
}

}  // namespace

Value read_value(Cursor& cursor) {
    const auto* item = cursor.peek();
    if (!item) cursor.fail_expected("a value");
    if (const auto* expression = std::get_if<ast::Expression>(&item->node)) {
        auto value = evaluate(cursor.session(), *expression);
        cursor.advance();
        return value;
    }
    if (starts_color(cursor)) return {cursor.color()};
    if (const auto* block = std::get_if<ast::Block>(&item->node)) return read_block(cursor, *block);
    if (const auto* array = std::get_if<std::unique_ptr<ast::Array>>(&item->node)) {
        auto value = read_array(cursor.session(), **array, item->span);
        cursor.advance();
        return value;
    }
    if (std::holds_alternative<ast::Function>(item->node)) {
        Refusal refusal{"function", item->span, {}};
        cursor.advance();
        return {refusal};
    }
    cursor.fail_expected("a value");
}

}  // namespace meniscus::lang
