#include "lang/flatten.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "lang/evaluate.hpp"
#include "lang/extent.hpp"
#include "lang/read_mesh.hpp"
#include "lang/read_transform.hpp"

namespace meniscus::lang {
namespace {

using geom::Transform;

/// A texture as its members inherit it: made into one of the scene's when first used.
struct Skin {
    const TextureItem* texture = nullptr;  // null with `clear`: the skin of a material
    bool clear = false;
    Transform outer;
    std::optional<std::size_t> index;
};

/// What an object takes from the unions around it.
struct Inherited {
    Transform outer;
    Skin* skin = nullptr;
    std::optional<std::size_t> solid;
    bool no_shadow = false, no_image = false, no_reflection = false, double_illuminate = false,
         hollow = false;
};

bool is_finite(const Transform& t) {
    double sum = t.shift().x + t.shift().y + t.shift().z;
    for (int i = 0; i < 3; ++i) sum += t.linear()[i].x + t.linear()[i].y + t.linear()[i].z;
    for (int i = 0; i < 3; ++i)
        sum += t.inverse_linear()[i].x + t.inverse_linear()[i].y + t.inverse_linear()[i].z;
    return std::isfinite(sum);
}

std::size_t make_texture(Session& session, const Skin& skin) {
    auto& textures = session.scene.textures;
    if (skin.clear) {
        textures.push_back(scene::Texture::clear_skin());
        return textures.size() - 1;
    }
    const auto& item = *skin.texture;
    for (const auto* refusal :
         {&item.refusal, &item.pigment.refusal, &item.finish.refusal, &item.normal.refusal}) {
        if (*refusal) throw refuse(**refusal);
    }
    if (item.has_layer_below && lets_light_through(item.pigment.pigment)) {
        throw refuse({"layered textures", item.span, {}});
    }
    scene::Texture texture;
    texture.pigment = item.pigment.pigment;
    texture.finish = item.finish.finish;
    texture.transform = chain_transforms(item.transform, skin.outer, item.span);
    textures.push_back(std::move(texture));
    return textures.size() - 1;
}

/// The object's own interior; old scenes put `ior` into the finish.
Boxed<InteriorItem> stated_interior(const ObjectItem& object) {
    auto interior = object.interior;
    if (object.texture) {
        const auto& finish = object.texture->finish;
        if (finish.ior || finish.caustics) {
            if (!interior) interior = InteriorItem{};
            if (finish.ior) {
                interior->interior.ior = *finish.ior;
                interior->interior.states_ior = true;
            }
            if (finish.caustics) interior->interior.caustics = *finish.caustics;
        }
    }
    return interior;
}

std::string name_of(const ObjectItem& object) {
    return object.name.empty() ? object.keyword : object.name;
}

std::size_t make_solid(Session& session, const ObjectItem& object,
                       const Boxed<InteriorItem>& interior) {
    if (interior && interior->refusal) throw refuse(*interior->refusal);
    session.scene.solids.push_back({name_of(object), object.span.location(),
                                    interior ? interior->interior : scene::Interior{}});
    return session.scene.solids.size() - 1;
}

class Flattener {
public:
    explicit Flattener(Session& session) : session_(session) {}

    void add(const ObjectItem& object, Inherited from) {
        if (object.refusal) throw refuse(*object.refusal);
        if (const auto* refusal = std::get_if<Refusal>(&object.body)) throw refuse(*refusal);
        if (const auto* light = std::get_if<LightItem>(&object.body))
            return add_light(object, *light, from);

        Skin skin;
        if (object.texture || object.clear) {
            skin = {object.texture ? &*object.texture : nullptr, object.clear && !object.texture,
                    from.outer, std::nullopt};
            from.skin = &skin;
        }
        if (const auto interior = stated_interior(object)) {
            from.solid = make_solid(session_, object, interior);
        } else if (!from.solid) {
            from.solid = make_solid(session_, object, {});
        }
        from.outer = chained(object, from.outer);
        from.no_shadow |= object.no_shadow;
        from.no_image |= object.no_image;
        from.no_reflection |= object.no_reflection;
        from.double_illuminate |= object.double_illuminate;
        from.hollow |= object.hollow;
        if (const auto* group = std::get_if<Union>(&object.body)) {
            if (object.inverse) throw refuse({"inverse on a union", object.span, {}});
            make_room(group->members.size());
            for (const auto& member : group->members) add(*member, from);
        } else {
            const auto* file = std::get_if<MeshFile>(&object.body);
            add_shape(object,
                      file ? load_mesh_file(session_, *file) : std::get<geom::Shape>(object.body),
                      from);
        }
    }

private:
    /// A union of very many is the better for knowing it; others grow as vectors do.
    void make_room(std::size_t count) {
        auto& objects = session_.scene.objects;
        if (count > objects.capacity() / 2) objects.reserve(objects.size() + count);
    }

    Transform chained(const ObjectItem& object, const Transform& outer) const {
        try {
            auto transform = object.transform.then(outer);
            if (is_finite(transform)) return transform;
        } catch (const std::invalid_argument&) {
        }
        throw SourceError(object.span,
                          "the transformations of this object are too small or too large together");
    }

    void add_shape(const ObjectItem& object, const geom::Shape& shape, const Inherited& from) {
        if (session_.scene.objects.size() >= session_.options.limits.objects) {
            throw SourceError(object.span, fmt::format("the scene has more than {} objects",
                                                       session_.options.limits.objects));
        }
        check_extent(
            geom::magnitude(shape) * from.outer.largest_scale() + geom::max_abs(from.outer.shift()),
            "this object", object.span);
        if (!from.skin->index) from.skin->index = make_texture(session_, *from.skin);
        scene::Object result;
        result.shape = shape;
        result.transform = from.outer;
        result.solid = *from.solid;
        result.texture = *from.skin->index;
        result.name = name_of(object);
        result.location = object.span.location();
        result.inverse = object.inverse;
        result.no_shadow = from.no_shadow;
        result.no_image = from.no_image;
        result.no_reflection = from.no_reflection;
        result.double_illuminate = from.double_illuminate;
        result.hollow = from.hollow;
        session_.scene.objects.push_back(std::move(result));
    }

    void add_light(const ObjectItem& object, const LightItem& item, Inherited from) {
        if (item.refusal) throw refuse(*item.refusal);
        if (session_.scene.lights.size() >= session_.options.limits.objects)
            throw SourceError(object.span, "too many lights");
        from.outer = chained(object, from.outer);
        auto light = item.light;
        light.position = from.outer.point(light.position);
        light.point_at = from.outer.point(light.point_at);
        check_extent(geom::max_abs(light.position), "this light", object.span);
        light.location = object.span.location();
        session_.scene.lights.push_back(std::move(light));
        from.solid.reset();
        for (const auto& part : item.looks_like) add(*part, from);
    }

    Session& session_;
};

}  // namespace

void add_to_scene(Session& session, const ObjectItem& object) {
    Skin standard;
    const auto default_texture = session.default_texture;
    standard.texture = &default_texture;
    Inherited from;
    from.skin = &standard;
    try {
        Flattener(session).add(object, from);
    } catch (SourceError& error) {
        const auto at = object.span.location();
        const auto& blamed = error.primary().location;
        if (blamed.line != at.line || blamed.file != at.file) {
            const auto text = fmt::format("used at {}:{}:{}", at.file, at.line, at.column);
            error.add_note({Diagnostic::Severity::note, {}, text, {}, 0});
        }
        throw;
    }
}

}  // namespace meniscus::lang
