#include "geom/sphere.hpp"

namespace meniscus::geom {

Interval Sphere::interval(const Ray& ray, Face pin) const {
    const Vec3 e = ray.from(center);
    const double dd = glm::dot(ray.direction, ray.direction);
    const double b = glm::dot(e, ray.direction) / dd;
    if (pin == 0) {
        // The origin is on the sphere: one root is 0, and the two add up to -2b.
        if (b < 0.0) return {0.0, -2.0 * b, 0, 0, true};
        return {-2.0 * b, 0.0, 0, 0, b > 0.0};
    }
    // r^2 - f.f with f the foot of the perpendicular keeps its digits far away, where b^2 - e.e +
    // r^2 does not (Haines et al. 2019).
    const Vec3 f = e - b * ray.direction;
    const double discriminant = (radius * radius - glm::dot(f, f)) / dd;
    if (!(discriminant > 0.0)) return {-b, -b, 0, 0, false};
    const double half = glm::sqrt(discriminant);
    return {-b - half, -b + half, 0, 0, true};
}

bool Sphere::contains(const Vec3& p) const {
    const Vec3 e = p - center;
    return glm::dot(e, e) < radius * radius;
}

Vec3 Sphere::normal(Face, const Ray& point) const {
    const Vec3 e = point.from(center);
    const double length = glm::length(e);
    return length > 0.0 ? e / length : Vec3{0.0, 1.0, 0.0};
}

Vec3 Sphere::to_face(Face, const Ray& point) const {
    const Vec3 e = point.from(center);
    const double length = glm::length(e);
    return length > 0.0 ? e * ((radius - length) / length) : Vec3{0.0, radius, 0.0};
}

}  // namespace meniscus::geom
