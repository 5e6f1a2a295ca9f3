#include "geom/box.hpp"

namespace meniscus::geom {

Interval Box::interval(const Ray& ray, Face pin) const {
    const Vec3 lower = low(), upper = high();
    const Vec3 from_low = ray.from(lower), from_high = ray.from(upper);
    Interval result{-infinity, infinity, no_face, no_face, true};
    for (int axis = 0; axis < 3; ++axis) {
        const Face low_face = 2 * axis, high_face = low_face + 1;
        const double d = ray.direction[axis];
        if (d == 0.0) {
            // Half open, so that a line within a shared face belongs to one of two stacked boxes.
            const bool above = from_low[axis] >= 0.0 || pin == low_face;
            const bool below = from_high[axis] < 0.0 && pin != high_face;
            if (!(above && below)) result.hit = false;
            continue;
        }
        const double inverse = 1.0 / d;
        const double at_low = pin == low_face ? 0.0 : -from_low[axis] * inverse;
        const double at_high = pin == high_face ? 0.0 : -from_high[axis] * inverse;
        const bool upwards = d > 0.0;
        const double near = upwards ? at_low : at_high, far = upwards ? at_high : at_low;
        if (near > result.t0) {
            result.t0 = near;
            result.face0 = upwards ? low_face : high_face;
        }
        if (far < result.t1) {
            result.t1 = far;
            result.face1 = upwards ? high_face : low_face;
        }
    }
    if (!(result.t0 < result.t1)) result.hit = false;
    return result;
}

bool Box::contains(const Vec3& p) const {
    const Vec3 lower = low(), upper = high();
    return p.x > lower.x && p.y > lower.y && p.z > lower.z && p.x < upper.x && p.y < upper.y &&
           p.z < upper.z;
}

Vec3 Box::normal(Face face, const Vec3&) const {
    Vec3 n{0.0};
    n[face / 2] = face % 2 == 1 ? 1.0 : -1.0;
    return n;
}

Vec3 Box::to_face(Face face, const Ray& point) const {
    const int axis = face / 2;
    Vec3 way{0.0};
    way[axis] = -point.from(face % 2 == 1 ? high() : low())[axis];
    return way;
}

}  // namespace meniscus::geom
