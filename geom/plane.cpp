#include "geom/plane.hpp"

namespace meniscus::geom {

Interval Plane::interval(const Ray& ray, Face pin) const {
    const Vec3 n = direction / glm::length(direction);
    const double slope = glm::dot(ray.direction, n);
    const double depth =
        (distance - glm::dot(ray.origin, n)) - glm::dot(ray.origin_error, n);  // > 0: inside
    if (slope == 0.0) return {-infinity, infinity, no_face, no_face, pin != 0 && depth > 0.0};
    const double t = pin == 0 ? 0.0 : depth / slope;
    if (slope > 0.0) return {-infinity, t, no_face, 0, true};
    return {t, infinity, 0, no_face, true};
}

bool Plane::contains(const Vec3& p) const {
    return glm::dot(p, direction / glm::length(direction)) < distance;
}

Vec3 Plane::normal(Face, const Vec3&) const { return direction / glm::length(direction); }

Vec3 Plane::to_face(Face face, const Ray& point) const {
    const Vec3 n = normal(face, point.origin);
    return n * ((distance - glm::dot(point.origin, n)) - glm::dot(point.origin_error, n));
}

}  // namespace meniscus::geom
