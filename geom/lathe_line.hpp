#pragma once

#include "geom/cylindrical.hpp"

namespace meniscus::geom {

/// A line as a lathe sees it: with unit direction, from its point nearest to the middle of the
/// lathe. t of the ray is (shift + t) / length. In the half-plane of radius and height its path is
/// one branch of a hyperbola: it comes nearer to the axis until `nearest`, and goes away after it.
struct LatheLine {
    double length, shift;
    AxialRay ray;     // across: y is 0
    double dd;        // square of the direction's part across the axis
    double nearest;   // -infinity where the line is parallel to the axis
    double closest2;  // square of the distance from the axis there

    LatheLine(const Ray& whole, double middle) : length(glm::length(whole.direction)) {
        const Vec3 d = whole.direction / length, from_middle = whole.from({0.0, middle, 0.0});
        shift = -glm::dot(from_middle, d);
        const Vec3 e = from_middle + shift * d;
        ray = {e.y + middle, d.y, {e.x, 0.0, e.z}, {d.x, 0.0, d.z}};
        dd = d.x * d.x + d.z * d.z;
        const double moment = e.x * d.z - e.z * d.x;
        nearest = dd > 0.0 ? -(e.x * d.x + e.z * d.z) / dd : -infinity;
        closest2 = dd > 0.0 ? moment * moment / dd : e.x * e.x + e.z * e.z;
    }

    double ray_t(double t) const { return (shift + t) / length; }
    double height(double t) const { return ray.along_e + t * ray.along_d; }
    double radius2(double t) const {
        const double x = ray.across_e.x + t * ray.across_d.x;
        const double z = ray.across_e.z + t * ray.across_d.z;
        return x * x + z * z;
    }
};

}  // namespace meniscus::geom
