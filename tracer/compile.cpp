#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tracer/hidden.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::tracer {
namespace {

/// An opaque solid without ior, priority or attenuation of its own stands in no list (its surface
/// is always met).
bool is_medium(const scene::Solid& solid, const scene::Texture& texture) {
    const scene::Interior& interior = solid.interior;
    return interior.states_ior || interior.states_priority || interior.attenuates() ||
           texture.clear || scene::lets_light_through(texture.pigment);
}

/// Whether rays to lights need not know where they are: what is not opaque takes nothing away, and
/// no medium hides what is.
bool shades_by_opaque_alone(const RenderScene& scene) {
    return scene.has_members && !scene.has_attenuation &&
           std::ranges::all_of(scene.parts, [&](const Part& part) {
               if (part.is_opaque) return !part.is_member;
               const scene::Object& object = scene.source.objects[std::size_t(part.object)];
               const scene::Solid& solid = scene.source.solids[std::size_t(part.solid)];
               return part.no_shadow || (scene.source.textures[object.texture].clear &&
                                         solid.interior.caustics == 0.0);
           });
}

/// The one part that is opaque, if it is a half-space.
int lone_floor(const RenderScene& scene) {
    int lone = outside;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        if (!part.is_opaque || part.no_shadow) continue;
        if (lone != outside || !std::holds_alternative<geom::Plane>(part.shape.shape()))
            return outside;
        lone = int(i);
    }
    return lone;
}

/// A hierarchy over so few parts costs more than it saves.
constexpr std::size_t few_parts = 4;
/// From so many spheres on they have a table of their own.
constexpr std::size_t many_spheres = 8;

/// Whether a line that misses the shape is told so soon.
bool is_cheap(const geom::PlacedShape& shape) {
    return (shape.is_convex() || std::holds_alternative<geom::Mesh>(shape.shape())) &&
           !std::holds_alternative<geom::Cone>(shape.shape());
}

void gather_spheres(RenderScene& scene) {
    std::vector<geom::Sphere> spheres;
    std::size_t count = 0;
    for (const int index : scene.bvh_parts) {
        const geom::PlacedShape& shape = scene.parts[std::size_t(index)].shape;
        const auto* sphere = std::get_if<geom::Sphere>(&shape.shape());
        const bool is_plain = sphere && shape.transform().is_identity();
        spheres.push_back(is_plain ? *sphere : geom::Sphere{geom::Vec3{0.0}, 0.0});
        count += is_plain;
    }
    if (count >= many_spheres) scene.bvh_spheres = std::move(spheres);
}

void add_parts(RenderScene& scene) {
    // A solid with several objects is a medium if any of them is.
    const scene::Scene& source = scene.source;
    std::vector<bool> solid_is_medium(source.solids.size(), false);
    for (const scene::Object& object : source.objects) {
        if (is_medium(source.solids[object.solid], source.textures[object.texture]))
            solid_is_medium[object.solid] = true;
    }
    scene.parts.reserve(source.objects.size());
    for (std::size_t i = 0; i < source.objects.size(); ++i) {
        const scene::Object& object = source.objects[i];
        const scene::Texture& texture = source.textures[object.texture];
        geom::PlacedShape shape(object.shape, object.transform);
        const bool closed = shape.is_closed();
        scene.parts.push_back(
            {.shape = std::move(shape),
             .object = int(i),
             .solid = int(object.solid),
             .priority = source.solids[object.solid].interior.priority,
             .is_member = closed && solid_is_medium[object.solid],
             .is_opaque = !texture.clear && !scene::lets_light_through(texture.pigment),
             .inverse = object.inverse,
             .no_shadow = object.no_shadow,
             .no_image = object.no_image,
             .no_reflection = object.no_reflection,
             .double_illuminate = object.double_illuminate});
    }
}

/// Whether a part stands in the scene's hierarchy.
bool is_finite(const Part& part) { return part.shape.bounds().is_finite() && !part.inverse; }

void measure(RenderScene& scene) {
    geom::Bounds finite;
    for (const Part& part : scene.parts) {
        if (is_finite(part)) finite.extend(part.shape.bounds());
    }
    if (!finite.is_empty()) scene.size = std::max(glm::length(finite.size()), 1e-300);
    scene.contact_tolerance = scene.source.settings.contact_tolerance.value_or(0.0);
}

void build_hierarchy(RenderScene& scene) {
    scene.bvh_parts.clear();
    scene.unbounded.clear();
    std::vector<geom::Bounds> bounds;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        if (is_finite(part)) {
            bounds.push_back(part.shape.bounds());
            scene.bvh_parts.push_back(int(i));
        } else {
            scene.unbounded.push_back(int(i));
        }
    }
    scene.bvh = geom::Bvh(bounds);
    std::vector<int> parts;
    for (const std::uint32_t box : scene.bvh.renumber()) parts.push_back(scene.bvh_parts[box]);
    scene.bvh_parts = std::move(parts);
}

/// What the parts that are left need.
void take_stock(RenderScene& scene) {
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        scene.priorities.push_back(part.priority);
        if (!part.is_member) continue;
        scene.has_members = true;
        if (part.no_image || part.no_reflection) scene.selective.push_back(int(i));
        if (scene.source.solids[std::size_t(part.solid)].interior.attenuates())
            scene.has_attenuation = true;
    }
    if (scene.source.settings.outside.attenuates()) scene.has_attenuation = true;
    scene.has_few_parts =
        scene.bvh_parts.size() <= few_parts &&
        std::ranges::all_of(scene.parts, [](const Part& part) { return is_cheap(part.shape); });
    gather_spheres(scene);
}

/// Whether no member comes near another.
bool are_members_apart(const RenderScene& scene) {
    const auto is_member = [&](int part) { return scene.parts[std::size_t(part)].is_member; };
    if (std::ranges::any_of(scene.unbounded, is_member)) return false;
    return std::ranges::all_of(scene.bvh_parts, [&](int part) {
        const Neighbours::Near& near = scene.neighbours.near[std::size_t(part)];
        return !is_member(part) ||
               (near.count != Neighbours::unknown &&
                std::none_of(near.parts.begin(), near.parts.begin() + near.count, is_member));
    });
}

/// Whether the camera's rays start in one place that is in no solid and on none.
bool is_camera_clear(const RenderScene& scene) {
    const scene::Camera& camera = scene.source.camera;
    if (camera.kind != scene::Camera::Kind::perspective) return false;
    const geom::Vec3& p = camera.location;
    const double margin = 1e-6 * (geom::max_abs(p) + scene.size) + scene.contact_tolerance;
    return std::ranges::all_of(scene.parts, [&](const Part& part) {
        if (!part.is_member) return true;
        if (part.inverse) return false;
        if (const auto* plane = std::get_if<geom::Plane>(&part.shape.shape());
            plane && part.shape.transform().is_identity())
            return glm::dot(p, plane->normal(0, p)) - plane->distance > margin;
        return !overlap(part.shape.bounds().padded(margin), {p, p});
    });
}

}  // namespace

RenderScene compile(scene::Scene source, Hidden hidden) {
    RenderScene result;
    result.source = std::move(source);
    const scene::Scene& scene = result.source;
    add_parts(result);
    measure(result);
    build_hierarchy(result);
    if (hidden == Hidden::left_out) {
        if (const std::size_t count = leave_out_hidden(result); count > 0) {
            build_hierarchy(result);
            result.skipped.push_back(
                fmt::format("hidden inside of what is stronger: {} of {} shapes", count,
                            count + result.parts.size()));
        }
    }
    take_stock(result);

    result.neighbours = find_neighbours(result);
    result.nesting = find_nesting(result);
    find_anchors(result);
    if (result.anchors.empty())
        result.skipped.emplace_back("no thin film far from the origin: one contact tolerance");
    result.only_opaque_shades = shades_by_opaque_alone(result);
    if (result.only_opaque_shades) result.lone_floor = lone_floor(result);
    if (!result.has_members) {
        result.skipped.emplace_back("no dielectric: no interior lists");
    } else {
        if (are_members_apart(result))
            result.skipped.emplace_back("no dielectrics that meet: no priorities to compare");
        result.is_camera_clear = is_camera_clear(result);
        if (result.is_camera_clear)
            result.skipped.emplace_back("camera in no solid: its rays start with an empty list");
    }
    if (!result.has_attenuation) result.skipped.emplace_back("no absorption: no exponentials");
    if (scene.lights.empty()) {
        result.skipped.emplace_back("no light: no shadow rays");
    } else if (result.lone_floor != outside) {
        result.skipped.emplace_back("no shadow but of one half-space: no shadow rays from it");
    } else if (result.only_opaque_shades) {
        result.skipped.emplace_back("no shadow of what is clear: no lists on the way to lights");
    }
    return result;
}

}  // namespace meniscus::tracer
