#include "geom/cylindrical.hpp"

namespace meniscus::geom {

Vec3 unit_across(const AxialPoint& p, const Axis& axis) {
    const double length = glm::length(p.across);
    return length > 0.0 ? p.across / length : any_perpendicular(axis.direction);
}

Interval between_caps(const AxialRay& ray, double length, Face pin, Face base_face, Face cap_face) {
    const bool on_base = pin == base_face, on_cap = pin == cap_face;
    if (ray.along_d == 0.0) {
        // Half open as a box: a line within the base belongs to the solid, one within the cap does
        // not.
        const bool between = (on_base || ray.along_e >= 0.0) && !on_cap && ray.along_e < length;
        return {-infinity, infinity, no_face, no_face, between};
    }
    const double at_base = on_base ? 0.0 : -ray.along_e / ray.along_d;
    const double at_cap = on_cap ? 0.0 : (length - ray.along_e) / ray.along_d;
    const bool upwards = ray.along_d > 0.0;
    Interval result{-infinity, infinity, no_face, no_face, true};
    if (upwards) {
        clip(result, at_base, base_face, at_cap, cap_face);
    } else {
        clip(result, at_cap, cap_face, at_base, base_face);
    }
    return result;
}

Bounds disc_bounds(const Vec3& center, const Vec3& direction, double radius) {
    // Along each axis the disc reaches r sqrt(1 - n^2); a little more never hurts.
    const Vec3 n = direction / glm::length(direction);
    const Vec3 reach =
        radius * glm::sqrt(glm::max(Vec3{0.0}, (Vec3{1.0} - n) * (Vec3{1.0} + n)) + Vec3{1e-15});
    return {center - reach, center + reach};
}

Vec3 any_perpendicular(const Vec3& v) {
    const Vec3 a = glm::abs(v);
    Vec3 other{0.0};
    other[a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2] = 1.0;
    return glm::normalize(glm::cross(v, other));
}

}  // namespace meniscus::geom
