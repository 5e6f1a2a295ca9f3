#include <algorithm>
#include <cmath>

#include "tracer/attenuation.hpp"
#include "tracer/pigment.hpp"
#include "tracer/ray_tree.hpp"
#include "tracer/shading.hpp"

namespace meniscus::tracer {

using scene::Rgb;

Rgb RayTree::unshadowed(TracedRay shadow, double distance, double way) {
    const geom::Vec3 direction = shadow.ray.direction;
    Rgb left{1.0};
    const auto attenuate = [&](int solid, double t) {
        way += t;
        const scene::Interior& around = medium(scene_, solid);
        if (around.attenuates()) left *= transmittance(around, way, true);
        way = 0.0;
    };
    Event hit;
    while (true) {
        if (!finder_.next(shadow, distance, hit)) {
            attenuate(shadow.interior.top_solid(scene_), distance);
            return left;
        }
        distance -= hit.t;
        const Part& part = scene_.parts[hit.skin];
        const scene::Texture& texture =
            scene_.source.textures[scene_.source.objects[part.object].texture];
        const scene::Interior& around = medium(scene_, hit.solid_before);
        const bool alike =
            scene_.parts[hit.part].is_member && around.same_medium(medium(scene_, hit.solid_after));
        if (alike && texture.clear) {
            way += hit.t;
        } else {
            attenuate(hit.solid_before, hit.t);
            if (!part.no_shadow) {
                if (part.is_opaque) return Rgb{0.0};
                left *= evaluate(texture, hit.origin.at(0.0)).transparency();
                const double caustics = scene_.source.solids[part.solid].interior.caustics;
                if (caustics != 0.0) {
                    const double cosine = std::abs(glm::dot(hit.normal, direction));
                    left *= 1.0 + std::pow(cosine, 45.0 * caustics);
                }
                if (scene::max_channel(left) == 0.0) return left;
            }
        }
        shadow.ray = hit.origin;
        shadow.ray.direction = direction;
        shadow.interior = hit.after;
        shadow.contacts = hit.contacts;
        for (Contact& contact : shadow.contacts) contact.starts_inside = !contact.starts_inside;
        shadow.birth = hit.birth;
    }
}

/// A surface with a texture: its own light, what it lets through, what it mirrors.
void RayTree::shade_textured(const Pending& pending, const Event& event, int node, Rgb& sum) {
    Shading shading;
    shading.lights = std::move(spare_lights_);
    const geom::Vec3& direction = pending.ray.ray.direction;
    shade(scene_, direction, event, event.shading_normal,
          tree_ == Tree::whitted ? std::optional(min_weight_) : std::nullopt, pending.key, shading);
    Rgb own = shading.own;
    for (const LightTerm& term : shading.lights) {
        Rgb visible{1.0};
        if (term.distance > 0.0) {
            ++statistics_.shadow_rays;
            TracedRay shadow = shadow_ray(event, term.direction, term.from_behind);
            shadow.kind = pending.ray.kind;
            finder_.become(shadow, RayKind::shadow);
            visible = unshadowed(std::move(shadow), term.distance);
        }
        own += visible * term.light;
    }
    spare_lights_ = std::move(shading.lights);
    sum += pending.throughput * own;
    if (record) {
        TreeNode& entry = record->at(node);
        entry.own_color = own;
        entry.reflectance = shading.mirror;
        entry.transmittance = shading.through;
        entry.total_reflection = shading.total_reflection;
    }
    const auto mirror = [&](const Rgb& share, double weight) {
        return Way{true, false, mirrored(direction, event.normal, shading.normal), share, weight};
    };
    if (shading.total_reflection) {  // in place of both branches, and not filtered
        branch(pending, event, node, mirror(Rgb{1.0}, scene::max_channel(shading.through)), {});
        return;
    }
    Way through;
    if (shading.transmitted) {
        through = {true, shading.straight, *shading.transmitted, shading.through,
                   scene::max_channel(shading.through)};
    }
    if (shading.mirror == Rgb{0.0} || shading.mirror_exponent == 1.0) {
        const bool exists = shading.mirror != Rgb{0.0};
        branch(pending, event, node, exists ? mirror(shading.mirror, shading.mirror_weight) : Way{},
               through);
        return;
    }
    // Not linear in the reflected light: that light is needed by itself.
    Pending alone;
    start(pending, event, node, mirror(Rgb{1.0}, 1.0), TreeNode::Branch::reflected, alone);
    alone.weight = pending.weight * shading.mirror_weight;
    ++statistics_.reflected_rays;
    const Rgb seen = follow(std::move(alone));
    sum += pending.throughput * shading.mirror *
           glm::pow(glm::max(seen, Rgb{0.0}), Rgb{1.0 / shading.mirror_exponent});
    branch(pending, event, node, {}, through);
}

}  // namespace meniscus::tracer
