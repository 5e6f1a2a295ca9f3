#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "geom/bounds.hpp"
#include "geom/bvh_node.hpp"
#include "geom/huge_pages.hpp"

namespace meniscus::geom {

/// A box to build over, seen from the hierarchy's centre and rounded outwards, and what it holds.
struct alignas(16) BuildItem {
    BuildItem() = default;
    BuildItem(const Bounds& box, const Vec3& center, std::uint32_t index);

    std::uint32_t index() const { return std::bit_cast<std::uint32_t>(low[3]); }
    float middle(int axis) const { return low[axis] + high[axis]; }  // twice that

    std::array<float, 4> low;  // the fourth has the bits of the index
    std::array<float, 4> high;
};

/// Rearranges the items so that leaf i holds those from i * leaf_size on, as many as that but for
/// the last leaf, and makes the nodes above them; the first is the root. The same items give the
/// same nodes for any number of threads.
HugeVector<BvhNode> build_bvh(std::vector<BuildItem>& items, std::uint32_t leaf_size);

}  // namespace meniscus::geom
