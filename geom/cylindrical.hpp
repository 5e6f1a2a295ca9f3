#pragma once

#include "geom/bounds.hpp"
#include "geom/crossing.hpp"
#include "geom/ray.hpp"

namespace meniscus::geom {

/// The line from the middle of one end to the middle of the other, of cylinders and cones.
struct Axis {
    Vec3 base, direction;
    double length;

    // By division: times 1 / length would make 0.9999999999999999 of an exact axis.
    Axis(const Vec3& from, const Vec3& to)
        : base(from), direction(to - from), length(glm::length(direction)) {
        direction /= length;
    }
};

/// A point as its way along the axis and its way from it.
struct AxialPoint {
    double along;
    Vec3 across;

    /// `e` is the vector from the axis' base to the point.
    AxialPoint(const Vec3& e, const Axis& axis)
        : along(glm::dot(e, axis.direction)), across(e - along * axis.direction) {}
};

/// A ray taken apart in the same way: e is the vector from the base to its origin, d its direction.
struct AxialRay {
    double along_e = 0.0, along_d = 0.0;
    Vec3 across_e{0.0}, across_d{0.0};
};

inline AxialRay axial(const Ray& ray, const Axis& axis) {
    const Vec3 e = ray.from(axis.base);
    const double along_e = glm::dot(e, axis.direction);
    const double along_d = glm::dot(ray.direction, axis.direction);
    return {along_e, along_d, e - along_e * axis.direction,
            ray.direction - along_d * axis.direction};
}

/// The unit vector from the axis to the point; any one across where the point is on the axis.
Vec3 unit_across(const AxialPoint& p, const Axis& axis);

/// Takes away from `interval` what is outside [near, far].
inline void clip(Interval& interval, double near, Face near_face, double far, Face far_face) {
    if (near > interval.t0) {
        interval.t0 = near;
        interval.face0 = near_face;
    }
    if (far < interval.t1) {
        interval.t1 = far;
        interval.face1 = far_face;
    }
    if (!(interval.t0 < interval.t1)) interval.hit = false;
}

/// What the planes of the two caps leave of a line.
Interval between_caps(const AxialRay& ray, double length, Face pin, Face base_face, Face cap_face);

/// The box around a disc.
Bounds disc_bounds(const Vec3& center, const Vec3& direction, double radius);

/// The way to a plane from a point that is off one of the plane's points by `e`.
inline Vec3 to_plane(const Vec3& e, const Vec3& unit_normal) {
    return -glm::dot(e, unit_normal) * unit_normal;
}

/// Some unit vector at a right angle to `v`.
Vec3 any_perpendicular(const Vec3& v);

}  // namespace meniscus::geom
