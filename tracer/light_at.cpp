#include "tracer/light_at.hpp"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace meniscus::tracer {
namespace {

using geom::Vec3;

double smooth_step(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Between the hot spot and the rim the light falls off by a smooth step in the cosine.
double spot_factor(const scene::Light& light, const Vec3& axis, const Vec3& to_light) {
    const double cosine = -glm::dot(to_light, axis);
    if (cosine <= 0.0) return 0.0;
    double factor = light.tightness == 0.0 ? 1.0 : std::pow(cosine, light.tightness);
    const double full = std::cos(glm::radians(light.radius));
    const double dark = std::cos(glm::radians(light.falloff));
    if (cosine < full) factor *= full > dark ? smooth_step((cosine - dark) / (full - dark)) : 0.0;
    return factor;
}

/// The same, in the distance from the axis.
double cylinder_factor(const scene::Light& light, const Vec3& axis, const Vec3& point) {
    const Vec3 from_light = point - light.position;
    const double along = glm::dot(from_light, axis);
    if (along <= 0.0) return 0.0;
    const double away = glm::length(from_light - along * axis);
    if (away >= light.falloff) return 0.0;
    double factor =
        light.tightness == 0.0 ? 1.0 : std::pow(1.0 - away / light.falloff, light.tightness);
    if (away > light.radius && light.falloff > light.radius) {
        factor *= smooth_step((light.falloff - away) / (light.falloff - light.radius));
    }
    return factor;
}

}  // namespace

LightAt light_at(const scene::Light& light, const geom::Vec3& point) {
    const Vec3 to_light = light.position - point;
    const bool has_axis = light.parallel || light.kind != scene::Light::Kind::point;
    const Vec3 axis = has_axis ? glm::normalize(light.point_at - light.position) : Vec3{0.0};

    LightAt seen;
    // A cylinder light's rays are parallel too, as POV-Ray's were measured to be.
    if (light.parallel || light.kind == scene::Light::Kind::cylinder) {
        seen.direction = -axis;
        seen.distance = glm::dot(to_light, seen.direction);
    } else {
        seen.distance = glm::length(to_light);
        seen.direction = seen.distance > 0.0 ? to_light / seen.distance : Vec3{0.0, 1.0, 0.0};
    }

    double factor = 1.0;
    if (light.kind == scene::Light::Kind::spot) factor = spot_factor(light, axis, seen.direction);
    if (light.kind == scene::Light::Kind::cylinder) factor = cylinder_factor(light, axis, point);
    if (light.fade_distance > 0.0 && light.fade_power > 0.0) {
        factor *=
            2.0 / (1.0 + std::pow(std::abs(seen.distance) / light.fade_distance, light.fade_power));
    }
    seen.color = factor * light.color;
    return seen;
}

}  // namespace meniscus::tracer
