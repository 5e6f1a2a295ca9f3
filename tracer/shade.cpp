#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/attenuation.hpp"
#include "tracer/fresnel.hpp"
#include "tracer/light_at.hpp"
#include "tracer/pigment.hpp"
#include "tracer/ray_tree.hpp"

namespace meniscus::tracer {
namespace {

using geom::Vec3;
using scene::Rgb;

double max_channel(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

/// POV-Ray's `metallic`: highlights and reflections take the pigment's colour, less so at grazing
/// angles. `x` is the angle as a share of 90 degrees.
Rgb metallic_tint(double metallic, double x, const Rgb& color) {
    if (metallic == 0.0) return Rgb{1.0};
    const double f = std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
    return Rgb{1.0} + metallic * (1.0 - f) * (color - Rgb{1.0});
}

double angle_share(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0)) / (std::numbers::pi / 2.0);
}

/// How much a finish reflects at this angle, per channel.
Rgb reflectivity(const scene::Reflection& reflection, double eta, double cosine, const Rgb& color) {
    if (!reflection.is_active()) return Rgb{0.0};
    Rgb rho;
    if (reflection.fresnel) {
        const double r = fresnel_reflectance(eta, cosine);
        rho = (1.0 - r) * reflection.min + r * reflection.max;
    } else {
        const double w = std::pow(1.0 - cosine, reflection.falloff);
        rho = (1.0 - w) * reflection.min + w * reflection.max;
    }
    return rho * metallic_tint(reflection.metallic, angle_share(cosine), color);
}

}  // namespace

/// What is left of a light after the solids on the way: straight on, through the true crossings
/// only. Zero behind anything opaque.
Rgb RayTree::unshadowed(const TracedRay& ray, const Event& event, const Vec3& direction,
                        double distance, bool from_behind) {
    ++statistics_.shadow_rays;
    TracedRay shadow;
    shadow.ray = event.origin;
    shadow.ray.direction = direction;
    shadow.interior = from_behind ? event.after : event.before;
    shadow.contacts = event.contacts;
    if (from_behind) {
        for (Contact& contact : shadow.contacts) contact.starts_inside = !contact.starts_inside;
    }
    shadow.birth_magnitude = event.magnitude;
    shadow.kind = RayKind::shadow;
    (void)ray;

    Rgb left{1.0};
    double way = 0.0;  // in this medium, since the last surface
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
                if (max_channel(left) == 0.0) return left;
            }
        }
        shadow.ray = hit->origin;
        shadow.ray.direction = direction;
        shadow.interior = hit->after;
        shadow.contacts = hit->contacts;
        shadow.birth_magnitude = hit->magnitude;
    }
}

/// Diffuse light and highlights of all lights, by POV-Ray's formulas.
Rgb RayTree::lit(const TracedRay& ray, const Event& event, const Vec3& normal,
                 const scene::Texture& texture, const scene::Color& color) {
    const scene::Finish& finish = texture.finish;
    const double diffuse = finish.diffuse * color.opacity();
    const bool has_highlight = finish.phong != 0.0 || finish.specular != 0.0;
    Rgb sum{0.0};
    if (diffuse == 0.0 && !has_highlight) return sum;

    const Vec3& eye_ray = ray.ray.direction;
    const Vec3 mirrored = reflect(eye_ray, normal);
    const bool both_sides = scene_.parts[event.skin].double_illuminate;
    const bool eye_is_outside = glm::dot(event.normal, eye_ray) < 0.0;
    for (const scene::Light& light : scene_.source.lights) {
        const LightAt seen = light_at(light, event.origin.origin);
        if (seen.color == Rgb{0.0}) continue;
        double cosine = glm::dot(normal, seen.direction);
        if (cosine < 1e-10 && !both_sides) continue;
        // Which side of the real surface the light is on decides where the shadow ray starts.
        const bool from_behind =
            both_sides && (glm::dot(event.normal, seen.direction) > 0.0) != eye_is_outside;
        cosine = std::abs(cosine);

        Rgb terms{0.0};
        if (diffuse != 0.0) {
            const double shape =
                finish.brilliance == 1.0 ? cosine : std::pow(cosine, finish.brilliance);
            terms += diffuse * shape * color.rgb;
        }
        if (has_highlight && !light.shadowless) {
            double highlight = 0.0;
            if (finish.phong != 0.0) {
                const double c = glm::dot(mirrored, seen.direction);
                if (c > 0.0) highlight += finish.phong * std::pow(c, finish.phong_size);
            }
            if (finish.specular != 0.0) {
                const double c = glm::dot(normal, glm::normalize(seen.direction - eye_ray));
                if (c > 0.0) highlight += finish.specular * std::pow(c, 1.0 / finish.roughness);
            }
            terms += highlight * metallic_tint(finish.metallic, angle_share(cosine), color.rgb);
        }
        if (terms == Rgb{0.0}) continue;
        Rgb visible{1.0};
        if (!light.shadowless && seen.distance > 0.0) {
            visible = unshadowed(ray, event, seen.direction, seen.distance, from_behind);
        }
        sum += visible * seen.color * terms;
    }
    return sum;
}

/// A surface with a texture, by POV-Ray's rules of composition: its own light, what it lets
/// through, what it mirrors.
void RayTree::shade_textured(Pending& pending, const Event& event, int node, RandomStream& random,
                             Rgb& sum) {
    const Part& part = scene_.parts[event.part];
    const scene::Texture& texture =
        scene_.source.textures[scene_.source.objects[scene_.parts[event.skin].object].texture];
    const scene::Finish& finish = texture.finish;
    const Vec3& direction = pending.ray.ray.direction;
    const Vec3 position = event.origin.origin;
    Vec3 normal = part.shape.shading_normal(event.face, position);
    if (glm::dot(normal, direction) > 0.0) normal = -normal;
    const double cosine = std::clamp(-glm::dot(normal, direction), 0.0, 1.0);

    const scene::Color color = evaluate(texture, position);
    const double opacity = color.opacity();
    Rgb own = color.rgb *
              (finish.ambient * scene_.source.settings.ambient_light + finish.emission) * opacity;
    own += lit(pending.ray, event, normal, texture, color);
    if (finish.crand != 0.0) own -= Rgb{finish.crand * random.next()};
    sum += pending.throughput * own;

    const double eta =
        medium(scene_, event.solid_before).ior / medium(scene_, event.solid_after).ior;
    const Rgb rho = reflectivity(finish.reflection, eta, cosine, color.rgb);
    Rgb through = color.transparency();
    if (finish.conserve_energy) through *= Rgb{1.0} - rho;
    if (record) {
        TreeNode& entry = record->at(node);
        entry.own_color = own;
        entry.reflectance = rho;
        entry.transmittance = through;
    }

    // Total reflection takes the place of both branches, and is not filtered.
    std::optional<Pending> transmitted_ray;
    const bool enters =
        tree_ == Tree::whitted ? scene::gray(through) > min_weight_ : through != Rgb{0.0};
    if (enters) {
        const bool straight = std::abs(eta - 1.0) < 1e-10 || !part.is_member;
        const std::optional<Vec3> refracted =
            straight ? std::optional<Vec3>(direction) : refract(direction, normal, eta);
        if (!refracted) {
            if (record) record->at(node).total_reflection = true;
            branch(pending, reflected(pending, event, normal, node), Rgb{1.0}, max_channel(through),
                   std::nullopt, Rgb{0.0}, 0.0, random);
            return;
        }
        transmitted_ray = transmitted(pending, event, *refracted, straight, node);
    }

    std::optional<Pending> mirror;
    double mirror_weight = max_channel(rho);
    if (rho != Rgb{0.0}) {
        const scene::Reflection& reflection = finish.reflection;
        if (!reflection.fresnel)
            mirror_weight = std::max(max_channel(reflection.min), max_channel(reflection.max));
        mirror = reflected(pending, event, normal, node);
        if (reflection.exponent != 1.0) {
            // Not linear in the reflected light: that light is needed by itself.
            Pending alone = std::move(*mirror);
            mirror.reset();
            alone.throughput = Rgb{1.0};
            alone.weight *= mirror_weight;
            ++statistics_.reflected_rays;
            const Rgb seen = follow(std::move(alone), random);
            sum += pending.throughput * rho *
                   glm::pow(glm::max(seen, Rgb{0.0}), Rgb{1.0 / reflection.exponent});
        }
    }
    branch(pending, std::move(mirror), rho, mirror_weight, std::move(transmitted_ray), through,
           max_channel(through), random);
}

}  // namespace meniscus::tracer
