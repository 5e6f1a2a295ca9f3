#pragma once

#include "geom/vec.hpp"

namespace meniscus::geom {

/// A half-line. Its exact origin is the sum of two vectors, `origin + origin_error`: the second
/// holds what rounding took from the first when the origin was computed, so that thin films far
/// from the coordinate origin stay apart.
struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0,
                   1.0};  // unit length in world coordinates; not so in a shape's own frame
    Vec3 origin_error{0.0};

    /// The vector from `point` to the origin.
    Vec3 from(const Vec3& point) const { return (origin - point) + origin_error; }

    /// The point at parameter `t`, rounded.
    Vec3 at(double t) const { return origin + (origin_error + t * direction); }
};

}  // namespace meniscus::geom
