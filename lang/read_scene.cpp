#include "lang/read_scene.hpp"

#include <fmt/format.h>

#include "grammar/words.hpp"
#include "lang/evaluate.hpp"
#include "lang/flatten.hpp"
#include "lang/read_camera.hpp"
#include "lang/read_object.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_texture.hpp"
#include "lang/read_transform.hpp"
#include "lang/suggest.hpp"

namespace meniscus::lang {
namespace {

const std::vector<std::string>& scene_words() {
    static const std::vector<std::string> words{"background",
                                                "box",
                                                "camera",
                                                "cone",
                                                "cylinder",
                                                "disc",
                                                "fog",
                                                "global_settings",
                                                "lathe",
                                                "light_source",
                                                "mesh",
                                                "mesh2",
                                                "object",
                                                "plane",
                                                "polygon",
                                                "sky_sphere",
                                                "smooth_triangle",
                                                "sphere",
                                                "torus",
                                                "triangle",
                                                "union"};
    return words;
}

void read_background(Cursor& cursor) {
    cursor.session().scene.background = to_scene_color(cursor.session(), cursor.color());
    cursor.expect_end();
}

/// The settings and surroundings: everything at the top of a file that is no object.
bool read_setting(Cursor& cursor, const ast::Block& block) {
    auto& session = cursor.session();
    const auto span = cursor.span();
    const auto word = block.word;
    Cursor inner(session, block, span);
    if (word == "camera") {
        session.scene.camera = resolve(read_camera(inner), block.word_span);
    } else if (word == "global_settings") {
        read_global_settings(inner);
    } else if (word == "background") {
        read_background(inner);
    } else if (word == "sky_sphere") {
        auto item = read_sky_sphere(inner);
        if (item.refusal) throw refuse(*item.refusal);
        session.scene.sky_sphere = std::move(item.sky);
    } else if (word == "default") {
        read_default(inner);
    } else {
        return false;
    }
    inner.expect_end();
    cursor.advance();
    return true;
}

void read_top_block(Cursor& cursor, const ast::Block& block) {
    if (is_object_word(block.word)) {
        add_to_scene(cursor.session(), read_object(cursor));
        return;
    }
    if (read_setting(cursor, block)) return;
    if (grammar::is_reserved(block.word)) {
        static constexpr std::string_view refused[] = {"fog", "rainbow", "media", "photons",
                                                       "radiosity"};
        for (const auto word : refused) {
            if (block.word == word) throw refuse({std::string(word), block.word_span, {}});
        }
        throw SourceError(block.word_span,
                          fmt::format("'{}' cannot stand outside an object", block.word));
    }
    fail_unknown_object(cursor.session(), block.word, block.word_span);
}

}  // namespace

void fail_unknown_object(Session& session, std::string_view word, const Span& span) {
    if (session.symbols.find(word)) {
        throw SourceError(
            span,
            fmt::format("'{0}' is a declared name: to use it, write 'object {{ {0} ... }}'", word));
    }
    throw SourceError(span,
                      fmt::format("unknown object '{}'{}", word, suggestion(word, scene_words())));
}

SkyItem read_sky_sphere(Cursor& cursor) {
    SkyItem item;
    while (!cursor.at_end()) {
        const auto* value = cursor.declared();
        const auto* block = cursor.block();
        if (const auto* other = value ? value->item<SkyItem>() : nullptr) {
            item = *other;
            cursor.advance();
        } else if (block && block->word == "pigment") {
            Cursor inner(cursor.session(), *block, cursor.span());
            auto pigment = read_pigment(inner, cursor.session().default_texture.pigment);
            if (pigment.refusal && !item.refusal) item.refusal = pigment.refusal;
            item.sky.pigments.push_back(std::move(pigment.pigment));
            cursor.advance();
        } else if (cursor.accept("emission")) {
            item.sky.emission = cursor.color().at[0];
        } else if (geom::Transform next; read_transform(cursor, next)) {
            for (auto& pigment : item.sky.pigments)
                pigment.transform = chain_transforms(pigment.transform, next, cursor.span());
        } else {
            cursor.fail_unknown();
        }
    }
    return item;
}

void read_scene(Cursor& cursor) {
    while (!cursor.at_end()) {
        if (const auto* block = cursor.block()) {
            read_top_block(cursor, *block);
            continue;
        }
        if (const auto* node = cursor.expression()) {
            const auto value = evaluate(cursor.session(), *node);
            throw SourceError(
                cursor.span(),
                fmt::format("expected an object or a directive, found {}", kind_of(value)));
        }
        cursor.fail_unknown();
    }
}

}  // namespace meniscus::lang
