#include "tracer/shading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lanes/chance.hpp"
#include "tracer/fresnel.hpp"
#include "tracer/light_at.hpp"
#include "tracer/pigment.hpp"

namespace meniscus::tracer {
namespace {

using geom::Vec3;
using scene::Rgb;

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

/// `crand`: POV-Ray takes a random number off the diffuse light of every lamp, before it is
/// coloured.
double grain(const scene::Finish& finish, std::uint64_t key, std::size_t light) {
    return finish.crand == 0.0 ? 0.0
                               : finish.crand * lanes::texture_chance(lanes::mix(key) + light);
}

/// Diffuse light and highlights of all lights, by POV-Ray's formulas.
void add_lights(const RenderScene& scene, const Vec3& eye_ray, const Event& event,
                const scene::Texture& texture, const scene::Color& color, std::uint64_t key,
                Shading& shading) {
    const scene::Finish& finish = texture.finish;
    const double diffuse = finish.diffuse * color.opacity();
    const bool has_highlight = finish.phong != 0.0 || finish.specular != 0.0;
    if (diffuse == 0.0 && !has_highlight) return;

    const Vec3& normal = shading.normal;
    const Vec3 mirrored = reflect(eye_ray, normal);
    const bool both_sides = scene.parts[event.skin].double_illuminate;
    const bool eye_is_outside = glm::dot(event.normal, eye_ray) < 0.0;
    for (std::size_t light_index = 0; light_index < scene.source.lights.size(); ++light_index) {
        const scene::Light& light = scene.source.lights[light_index];
        const LightAt seen = light_at(light, event.origin.at(0.0));
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
            terms += (diffuse * shape - grain(finish, key, light_index)) * color.rgb;
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
        const bool in_the_open = light.shadowless || !(seen.distance > 0.0) ||
                                 (scene.lone_floor != outside && event.skin == scene.lone_floor);
        shading.lights.push_back(
            {seen.color * terms, seen.direction, in_the_open ? 0.0 : seen.distance, from_behind});
    }
}

}  // namespace

geom::Vec3 mirrored(const Vec3& direction, const Vec3& true_normal, const Vec3& shading_normal) {
    const Vec3 result = reflect(direction, shading_normal);
    const Vec3 raw = glm::dot(true_normal, direction) < 0.0 ? true_normal : -true_normal;
    const double below = glm::dot(result, raw);
    if (below < 0.0 && shading_normal != true_normal)
        return glm::normalize(result - 2.0 * below * raw);
    return result;
}

TracedRay shadow_ray(const Event& event, const Vec3& direction, bool from_behind) {
    TracedRay shadow;
    shadow.ray = event.origin;
    shadow.ray.direction = direction;
    shadow.interior = from_behind ? event.after : event.before;
    shadow.contacts = event.contacts;
    if (from_behind) {
        for (Contact& contact : shadow.contacts) contact.starts_inside = !contact.starts_inside;
    }
    shadow.birth = event.birth;
    return shadow;
}

void shade(const RenderScene& scene, const Vec3& direction, const Event& event,
           const Vec3& shading_normal, std::optional<double> least_through, std::uint64_t key,
           Shading& shading) {
    const Part& part = scene.parts[event.part];
    const scene::Texture& texture =
        scene.source.textures[scene.source.objects[scene.parts[event.skin].object].texture];
    const scene::Finish& finish = texture.finish;
    const Vec3 position = event.origin.at(0.0);
    shading = {.lights = std::move(shading.lights)};
    shading.lights.clear();
    shading.normal = shading_normal;
    if (glm::dot(shading.normal, direction) > 0.0) shading.normal = -shading.normal;
    const double cosine = std::clamp(-glm::dot(shading.normal, direction), 0.0, 1.0);

    const scene::Color color = evaluate(texture, position);
    shading.own = color.rgb *
                  (finish.ambient * scene.source.settings.ambient_light + finish.emission) *
                  color.opacity();
    add_lights(scene, direction, event, texture, color, key, shading);

    const double eta = medium(scene, event.solid_before).ior / medium(scene, event.solid_after).ior;
    const scene::Reflection& reflection = finish.reflection;
    shading.mirror = reflectivity(reflection, eta, cosine, color.rgb);
    shading.mirror_exponent = reflection.exponent;
    shading.mirror_weight = reflection.fresnel ? scene::max_channel(shading.mirror)
                                               : std::max(scene::max_channel(reflection.min),
                                                          scene::max_channel(reflection.max));
    shading.through = color.transparency();
    if (finish.conserve_energy) shading.through *= Rgb{1.0} - shading.mirror;
    if (least_through ? scene::gray(shading.through) > *least_through
                      : shading.through != Rgb{0.0}) {
        shading.straight = std::abs(eta - 1.0) < 1e-10 || !part.is_member;
        shading.transmitted = shading.straight ? std::optional<Vec3>(direction)
                                               : refract(direction, shading.normal, eta);
        shading.total_reflection = !shading.transmitted;
    }
}

}  // namespace meniscus::tracer
