#include "geom/cylinder.hpp"

#include "geom/cylindrical.hpp"

namespace meniscus::geom {

namespace {

/// The two roots of the infinite side. Without any, `low` and `high` are where the line is nearest
/// to the axis.
struct SideRoots {
    double low, high;
    bool exist;
};

SideRoots side_roots(const AxialRay& ray, double radius, bool pinned) {
    const double dd = glm::dot(ray.across_d, ray.across_d);
    const double b = glm::dot(ray.across_d, ray.across_e) / dd;
    if (pinned) return {glm::min(0.0, -2.0 * b), glm::max(0.0, -2.0 * b), b != 0.0};
    const Vec3 f = ray.across_e - b * ray.across_d;
    const double discriminant = (radius * radius - glm::dot(f, f)) / dd;
    if (!(discriminant > 0.0)) return {-b, -b, false};
    const double half = glm::sqrt(discriminant);
    return {-b - half, -b + half, true};
}

bool is_parallel(const AxialRay& ray) {
    const double along = ray.along_d * ray.along_d;
    return glm::dot(ray.across_d, ray.across_d) < 1e-30 * along;
}

}  // namespace

Bounds Cylinder::bounds() const {
    Bounds result = disc_bounds(base, cap - base, radius);
    result.extend(disc_bounds(cap, cap - base, radius));
    return result;
}

Interval Cylinder::interval(const Ray& ray, Face pin) const {
    const Axis axis(base, cap);
    const AxialRay local = axial(ray, axis);
    Interval result = between_caps(local, axis.length, pin, base_face, cap_face);
    if (is_parallel(local)) {
        const double distance2 = glm::dot(local.across_e, local.across_e);
        if (pin == side_face || !(distance2 < radius * radius)) result.hit = false;
        return result;
    }
    const SideRoots roots = side_roots(local, radius, pin == side_face);
    clip(result, roots.low, side_face, roots.high, side_face);
    if (!roots.exist) result.hit = false;
    return result;
}

void Cylinder::hits(const Ray& ray, Crossings& out) const {
    const Axis axis(base, cap);
    const AxialRay local = axial(ray, axis);
    if (is_parallel(local)) return;
    const SideRoots roots = side_roots(local, radius, false);
    if (!roots.exist) return;
    for (const double t : {roots.low, roots.high}) {
        const double y = local.along_e + t * local.along_d;
        if (y >= 0.0 && y <= axis.length) out.push_back({t, side_face, t == roots.low});
    }
}

bool Cylinder::contains(const Vec3& p) const {
    const Axis axis(base, cap);
    const AxialPoint local(p - axis.base, axis);
    return local.along > 0.0 && local.along < axis.length &&
           glm::dot(local.across, local.across) < radius * radius;
}

Vec3 Cylinder::normal(Face face, const Ray& point) const {
    const Axis axis(base, cap);
    if (face == base_face) return -axis.direction;
    if (face == cap_face) return axis.direction;
    return unit_across(AxialPoint(point.from(axis.base), axis), axis);
}

Vec3 Cylinder::to_face(Face face, const Ray& point) const {
    const Axis axis(base, cap);
    if (face == base_face) return to_plane(point.from(base), axis.direction);
    if (face == cap_face) return to_plane(point.from(cap), axis.direction);
    const AxialPoint local(point.from(base), axis);
    return unit_across(local, axis) * (radius - glm::length(local.across));
}

}  // namespace meniscus::geom
