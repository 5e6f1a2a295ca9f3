#include "geom/bounds.hpp"

#include <cmath>

namespace meniscus::geom {

bool Bounds::is_finite() const {
    const auto finite = [](const Vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    };
    return finite(low) && finite(high);
}

double Bounds::area() const {
    if (is_empty()) return 0.0;
    const Vec3 s = size();
    return 2.0 * (s.x * s.y + s.y * s.z + s.z * s.x);
}

bool overlap(const Bounds& a, const Bounds& b) {
    return a.low.x <= b.high.x && a.low.y <= b.high.y && a.low.z <= b.high.z &&
           b.low.x <= a.high.x && b.low.y <= a.high.y && b.low.z <= a.high.z;
}

Span span_inside(const Bounds& bounds, const Vec3& origin, const Vec3& inverse_direction) {
    // Two roundings on either side of each product; widening by 4 covers them (Ize 2013).
    constexpr double widen = 4.0 * unit_roundoff;
    Span span{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (bounds.low[axis] - origin[axis]) * inverse_direction[axis];
        const double b = (bounds.high[axis] - origin[axis]) * inverse_direction[axis];
        if (std::isnan(a) || std::isnan(b)) continue;  // runs within the slab's face
        const double near = a < b ? a : b, far = a < b ? b : a;
        span.near = std::fmax(span.near, near - widen * std::fabs(near));
        span.far = std::fmin(span.far, far + widen * std::fabs(far));
    }
    return span;
}

}  // namespace meniscus::geom
