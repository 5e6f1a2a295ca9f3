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
    while (true) {
        const std::optional<Event> hit = finder_.next(shadow, distance);
        if (!hit) {
            attenuate(shadow.interior.top_solid(scene_), distance);
            return left;
        }
        distance -= hit->t;
        const Part& part = scene_.parts[hit->skin];
        const scene::Texture& texture =
            scene_.source.textures[scene_.source.objects[part.object].texture];
        const scene::Interior& around = medium(scene_, hit->solid_before);
        const bool alike = scene_.parts[hit->part].is_member &&
                           around.same_medium(medium(scene_, hit->solid_after));
        if (alike && texture.clear) {
            way += hit->t;
        } else {
            attenuate(hit->solid_before, hit->t);
            if (!part.no_shadow) {
                if (part.is_opaque) return Rgb{0.0};
                left *= evaluate(texture, hit->origin.origin).transparency();
                const double caustics = scene_.source.solids[part.solid].interior.caustics;
                if (caustics != 0.0) {
                    const double cosine = std::abs(glm::dot(hit->normal, direction));
                    left *= 1.0 + std::pow(cosine, 45.0 * caustics);
                }
                if (scene::max_channel(left) == 0.0) return left;
            }
        }
        shadow.ray = hit->origin;
        shadow.ray.direction = direction;
        shadow.interior = hit->after;
        shadow.contacts = hit->contacts;
        for (Contact& contact : shadow.contacts) contact.starts_inside = !contact.starts_inside;
        shadow.birth = hit->birth;
    }
}

/// A surface with a texture: its own light, what it lets through, what it mirrors.
void RayTree::shade_textured(Pending& pending, const Event& event, int node, Rgb& sum) {
    Shading shading;
    shading.lights = std::move(spare_lights_);
    shade(scene_, pending.ray.ray.direction, event,
          scene_.parts[event.part].shape.shading_normal(event.face, event.origin),
          tree_ == Tree::whitted ? std::optional(min_weight_) : std::nullopt, pending.key, shading);
    Rgb own = shading.own;
    for (const LightTerm& term : shading.lights) {
        Rgb visible{1.0};
        if (term.distance > 0.0) {
            ++statistics_.shadow_rays;
            visible =
                unshadowed(shadow_ray(event, term.direction, term.from_behind), term.distance);
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
    if (shading.total_reflection) {  // in place of both branches, and not filtered
        branch(pending, reflected(pending, event, shading.normal, node), Rgb{1.0},
               scene::max_channel(shading.through), std::nullopt, Rgb{0.0}, 0.0);
        return;
    }
    std::optional<Pending> through, mirror;
    if (shading.transmitted) {
        through = transmitted(pending, event, *shading.transmitted, shading.straight, node);
    }
    if (shading.mirror != Rgb{0.0}) {
        mirror = reflected(pending, event, shading.normal, node);
        if (shading.mirror_exponent != 1.0) {
            // Not linear in the reflected light: that light is needed by itself.
            Pending alone = std::move(*mirror);
            mirror.reset();
            alone.throughput = Rgb{1.0};
            alone.weight *= shading.mirror_weight;
            ++statistics_.reflected_rays;
            const Rgb seen = follow(std::move(alone));
            sum += pending.throughput * shading.mirror *
                   glm::pow(glm::max(seen, Rgb{0.0}), Rgb{1.0 / shading.mirror_exponent});
        }
    }
    branch(pending, std::move(mirror), shading.mirror, shading.mirror_weight, std::move(through),
           shading.through, scene::max_channel(shading.through));
}

}  // namespace meniscus::tracer
