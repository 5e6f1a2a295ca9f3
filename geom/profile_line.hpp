#pragma once

#include "geom/cylindrical.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

/// A straight line in the half-plane of radius and height: a * radius + b * height = c, with (a, b)
/// its unit normal. Turned about the axis it is a cone, a cylinder or a plane.
struct ProfileLine {
    double a, b, c;

    /// How far a point lies outside.
    double distance(double radius, double height) const { return a * radius + b * height - c; }

    /// One step of Newton's method for where the line meets the turned line, no longer than
    /// `limit`. It is the last word on a root: its error is that of `distance`, a few unit
    /// roundoffs of the coordinates, however blunt the quadratic was.
    double polish(const AxialRay& ray, double t, double limit) const {
        const Vec3 across = ray.across_e + t * ray.across_d;
        const double radius = glm::length(across);
        if (!(radius > 0.0)) return t;
        const double slope = a * glm::dot(across, ray.across_d) / radius + b * ray.along_d;
        const double step = distance(radius, ray.along_e + t * ray.along_d) / slope;
        return glm::abs(step) <= limit ? t - step : t;
    }
};

}  // namespace meniscus::geom
