#pragma once

#include <array>
#include <cmath>

#include "geom/bounds.hpp"
#include "geom/bvh_node.hpp"
#include "geom/ray.hpp"

namespace meniscus::geom {

/// Where the boxes of a hierarchy are.
struct BvhFrame {
    BvhFrame() = default;
    explicit BvhFrame(const Bounds& bounds)
        : center(bounds.center()),
          reach(0.5 * max_abs(bounds.size())),
          farthest(glm::max(max_abs(bounds.low), max_abs(bounds.high))) {}

    Vec3 center{0.0};       // they are seen from here
    double reach = 0.0;     // the largest offset from there
    double farthest = 0.0;  // the largest coordinate
};

/// A ray made ready for boxes. Its parameter starts at the point of its line nearest to the boxes'
/// centre, so that single precision does, from any distance; and its line is thick enough to cover
/// every rounding error, here and of what is in the boxes.
struct BvhLine {
    BvhLine(const BvhFrame& frame, const Ray& ray);

    /// A little more than t, as a parameter of this line.
    float upper(double t) const {
        const auto value = static_cast<float>(t - shift);
        return value + (value < 0.0f ? -value : value) * 0x1p-21f + slack;
    }
    float lower(double t) const {
        const auto value = static_cast<float>(t - shift);
        return value - (value < 0.0f ? -value : value) * 0x1p-21f - slack;
    }

    double shift;
    float slack;
    // Enter at (first side - near_side) * inverse, leave at (last side - far_side) * inverse.
    std::array<float, 3> near_side, far_side, inverse;
    std::array<bool, 3> backwards;  // the line runs down the axis: the high side comes first
};

[[gnu::always_inline]] inline BvhLine::BvhLine(const BvhFrame& frame, const Ray& ray) {
    const double dd = glm::dot(ray.direction, ray.direction), size = std::sqrt(dd);
    const Vec3 from_center = ray.from(frame.center);
    shift = -glm::dot(from_center, ray.direction) / dd;
    const Vec3 origin = from_center + shift * ray.direction;

    // Errors of crossings are a few double roundoffs of the largest coordinate in play; those in
    // here, of the offset from the centre.
    const double far = max_abs(ray.origin) + frame.farthest;
    const double margin = 128.0 * unit_roundoff * far + 0x1p-20 * (frame.reach + max_abs(origin));
    slack = static_cast<float>(margin / size);
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        backwards[axis] = d < 0.0;
        // A direction of 0 would give 0 * infinity; a tiny one is as good and gives large numbers
        // of the right sign.
        const bool is_tiny = glm::abs(d) < 1e-18 * size;
        inverse[axis] = static_cast<float>(is_tiny ? 1e18 / size : 1.0 / d);
        const double outwards = d < 0.0 ? -margin : margin;
        near_side[axis] = static_cast<float>(origin[axis] + outwards);
        far_side[axis] = static_cast<float>(origin[axis] - outwards);
    }
}

/// What is still to be visited, and where the line enters it.
struct BvhEntry {
    std::uint32_t child;
    float near;
};

/// No hierarchy is deeper (see bvh_builder.cpp), so no traversal needs a larger stack.
inline constexpr int max_bvh_depth = 84;
using BvhStack = std::array<BvhEntry, (BvhNode::width - 1) * max_bvh_depth + 1>;

}  // namespace meniscus::geom
