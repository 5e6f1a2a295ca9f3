#include "geom/disc.hpp"

#include "geom/cylindrical.hpp"

namespace meniscus::geom {

Bounds Disc::bounds() const { return disc_bounds(center, direction, radius); }

void Disc::hits(const Ray& ray, Crossings& out) const {
    const Vec3 n = normal(0, center);
    const double slope = glm::dot(ray.direction, n);
    if (slope == 0.0) return;
    const Vec3 e = ray.from(center);
    const double t = -glm::dot(e, n) / slope;
    const Vec3 across = e + t * ray.direction;
    const double distance2 = glm::dot(across, across);
    if (distance2 > radius * radius || distance2 < hole_radius * hole_radius) return;
    out.push_back({t, 0, slope < 0.0});
}

Vec3 Disc::normal(Face, const Vec3&) const { return direction / glm::length(direction); }

Vec3 Disc::to_face(Face face, const Ray& point) const {
    return to_plane(point.from(center), normal(face, center));
}

}  // namespace meniscus::geom
