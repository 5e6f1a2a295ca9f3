#include "geom/cone.hpp"

#include <cmath>

#include "geom/profile_line.hpp"

namespace meniscus::geom {

namespace {

ProfileLine side_line(const Cone& cone, double length) {
    const double slant = glm::length(Vec2{length, cone.base_radius - cone.cap_radius});
    const double a = length / slant, b = (cone.base_radius - cone.cap_radius) / slant;
    return {a, b, a * cone.base_radius};
}

/// The ray and the side seen from the narrower end, with the axis towards the wider one: there is
/// the point of the cone, if it has one, and no digits are lost about it.
struct FromNarrowEnd {
    AxialRay ray;
    ProfileLine side;
};

FromNarrowEnd from_narrow_end(const Cone& cone, const AxialRay& ray, double length) {
    const ProfileLine side = side_line(cone, length);
    if (cone.base_radius <= cone.cap_radius) return {ray, side};
    return {{length - ray.along_e, -ray.along_d, ray.across_e, ray.across_d},
            {side.a, -side.b, side.a * cone.cap_radius}};
}

/// The part of a line inside the infinite cone, on the side of its point where radii are positive.
struct SideSpan {
    double low, high;  // one of them may be infinite; equal where the line misses: the place
                       // nearest to a hit
    bool exists;
};

SideSpan side_span(const FromNarrowEnd& seen, double length, bool pinned) {
    // a^2 radius^2 = (c - b height)^2 is A t^2 + 2 B t + C = 0. Seen from the point of the line
    // nearest to the narrow end, the coefficients are free of the ray's distance.
    const auto& [ray, side] = seen;
    const double dd = glm::dot(ray.across_d, ray.across_d) + ray.along_d * ray.along_d;
    double shift =
        pinned ? 0.0 : -(glm::dot(ray.across_e, ray.across_d) + ray.along_e * ray.along_d) / dd;
    Vec3 across = ray.across_e + shift * ray.across_d;
    double width = side.c - side.b * (ray.along_e + shift * ray.along_d);
    const double widening = -side.b * ray.along_d;  // of the cone, along the ray
    const double a2 = side.a * side.a;
    const double A = a2 * glm::dot(ray.across_d, ray.across_d) - widening * widening;
    double B = a2 * glm::dot(across, ray.across_d) - width * widening;
    const double wide_radius = (side.c + glm::abs(side.b) * length) / side.a;
    const double size = (length + wide_radius) / glm::sqrt(dd);
    if (!pinned && glm::abs(B) < 4.0 * size * A) {
        // Seen from halfway between the roots, as Haines et al. (2019) do for spheres, a needle
        // passed at a distance keeps its digits.
        shift -= B / A;
        across = ray.across_e + shift * ray.across_d;
        width = side.c - side.b * (ray.along_e + shift * ray.along_d);
        B = a2 * glm::dot(across, ray.across_d) - width * widening;
    }
    const double C = pinned ? 0.0 : a2 * glm::dot(across, across) - width * width;

    if (A == 0.0) {
        // Parallel to the slope: one root, at which the line leaves this half or enters the other.
        if (B == 0.0) return {-infinity, infinity, C < 0.0};  // along a cylinder
        const double root = pinned ? 0.0 : side.polish(ray, shift - 0.5 * C / B, 1e-6 * size);
        if (B < 0.0) return {root, widening > 0.0 ? infinity : root, widening > 0.0};
        return {widening < 0.0 ? -infinity : root, root, widening < 0.0};
    }

    const double middle = -B / A;
    double discriminant = B * B - A * C;
    if (A > 0.0) {
        const bool misses = !(discriminant > 0.0) || (!pinned && width + middle * widening < 0.0);
        if (misses) return {shift + middle, shift + middle, false};
    } else if (discriminant < 0.0) {
        discriminant = 0.0;  // through the very point of the cone
    }

    double first, second;  // first <= second
    if (pinned) {
        const double other = side.polish(ray, 2.0 * middle, 1e-6 * glm::abs(middle));
        first = glm::min(0.0, other);
        second = glm::max(0.0, other);
    } else {
        const double root = glm::sqrt(discriminant);
        const double q = -(B + std::copysign(root, B));
        const double one = q / A;
        const double two = q != 0.0 ? C / q : one;
        // A step may not reach half-way to the other root, nor leap where the surface is almost
        // parallel to the ray.
        const double limit = glm::min(0.5 * root / glm::abs(A), 1e-6 * size);
        first = side.polish(ray, shift + glm::min(one, two), limit);
        second = side.polish(ray, shift + glm::max(one, two), limit);
    }
    if (A > 0.0) return {first, second, first < second};
    if (widening > 0.0) return {pinned ? 0.0 : second, infinity, true};
    return {-infinity, pinned ? 0.0 : first, true};
}

}  // namespace

Bounds Cone::bounds() const {
    Bounds result = disc_bounds(base, cap - base, base_radius);
    result.extend(disc_bounds(cap, cap - base, cap_radius));
    return result;
}

double Cone::magnitude() const {
    return glm::max(max_abs(base), max_abs(cap)) + glm::max(base_radius, cap_radius);
}

Interval Cone::interval(const Ray& ray, Face pin) const {
    const Axis axis(base, cap);
    const AxialRay local = axial(ray, axis);
    Interval result = between_caps(local, axis.length, pin, base_face, cap_face);
    const SideSpan side =
        side_span(from_narrow_end(*this, local, axis.length), axis.length, pin == side_face);
    clip(result, side.low, side_face, side.high, side_face);
    if (!side.exists) result.hit = false;
    return result;
}

void Cone::hits(const Ray& ray, Crossings& out) const {
    const Axis axis(base, cap);
    const AxialRay local = axial(ray, axis);
    const SideSpan side = side_span(from_narrow_end(*this, local, axis.length), axis.length, false);
    if (!side.exists) return;
    for (const double t : {side.low, side.high}) {
        const double y = local.along_e + t * local.along_d;
        if (y >= 0.0 && y <= axis.length && glm::abs(t) < infinity)
            out.push_back({t, side_face, t == side.low});
    }
}

bool Cone::contains(const Vec3& p) const {
    const Axis axis(base, cap);
    const AxialPoint local(p - axis.base, axis);
    return local.along > 0.0 && local.along < axis.length &&
           side_line(*this, axis.length).distance(glm::length(local.across), local.along) < 0.0;
}

Vec3 Cone::normal(Face face, const Ray& point) const {
    const Axis axis(base, cap);
    if (face == base_face) return -axis.direction;
    if (face == cap_face) return axis.direction;
    const ProfileLine side = side_line(*this, axis.length);
    return glm::normalize(side.a * unit_across(AxialPoint(point.from(axis.base), axis), axis) +
                          side.b * axis.direction);
}

Vec3 Cone::to_face(Face face, const Ray& point) const {
    const Axis axis(base, cap);
    if (face == base_face) return to_plane(point.from(base), axis.direction);
    if (face == cap_face) return to_plane(point.from(cap), axis.direction);
    const AxialPoint local(point.from(base), axis);
    const ProfileLine side = side_line(*this, axis.length);
    const Vec3 n = side.a * unit_across(local, axis) + side.b * axis.direction;
    return -side.distance(glm::length(local.across), local.along) * n;
}

}  // namespace meniscus::geom
