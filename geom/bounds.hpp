#pragma once

#include <limits>

#include "geom/ray.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

/// An axis-aligned box; the default is empty. Infinite shapes have infinite corners.
struct Bounds {
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};

    static Bounds everything() {
        return {Vec3{-std::numeric_limits<double>::infinity()},
                Vec3{std::numeric_limits<double>::infinity()}};
    }

    bool is_empty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
    bool is_finite() const;

    Vec3 center() const { return 0.5 * (low + high); }
    Vec3 size() const { return high - low; }
    double area() const;
    bool contains(const Vec3& p) const {
        return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y &&
               p.z <= high.z;
    }

    void extend(const Vec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void extend(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// The box grown by `margin` on every side.
    Bounds padded(double margin) const { return {low - Vec3{margin}, high + Vec3{margin}}; }
};

/// Whether the two boxes share a point; touching counts.
bool overlap(const Bounds& a, const Bounds& b);

/// The part [near, far] of the ray's line inside a box; empty when near > far. Never misses a box
/// by rounding.
struct Span {
    double near, far;
};
Span span_inside(const Bounds& bounds, const Vec3& origin, const Vec3& inverse_direction);

}  // namespace meniscus::geom
