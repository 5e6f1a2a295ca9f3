#pragma once

#include <array>
#include <cstdint>

namespace meniscus::geom {

/// The boxes of up to eight children, seen from the hierarchy's centre, rounded outwards. Those of
/// children that are not there are empty.
struct alignas(32) BvhNode {
    static constexpr int width = 8;
    /// In `child`: the rest is the number of a leaf, otherwise of a node.
    static constexpr std::uint32_t leaf = 0x80000000;

    std::array<std::array<std::array<float, width>, 2>, 3> sides;  // [axis][low, high][child]
    std::array<std::uint32_t, width> child;
};

}  // namespace meniscus::geom
