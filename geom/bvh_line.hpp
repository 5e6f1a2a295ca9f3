#pragma once

#include <array>

#include "geom/bounds.hpp"
#include "geom/bvh_node.hpp"
#include "geom/ray.hpp"

namespace meniscus::geom {

/// A ray made ready for boxes. Its parameter starts at the point of its line nearest to the boxes'
/// centre, so that single precision does, from any distance; and its line is thick enough to cover
/// every rounding error, here and of what is in the boxes.
struct BvhLine {
    BvhLine(const Bounds& bounds, const Vec3& center, const Ray& ray);

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

/// What is still to be visited, and where the line enters it.
struct BvhEntry {
    std::uint32_t child;
    float near;
};

/// No hierarchy is deeper (see bvh_builder.cpp), so no traversal needs a larger stack.
inline constexpr int max_bvh_depth = 84;
using BvhStack = std::array<BvhEntry, (BvhNode::width - 1) * max_bvh_depth + 1>;

}  // namespace meniscus::geom
