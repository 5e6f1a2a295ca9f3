#include "geom/bvh_builder.hpp"

#include <cmath>
#include <limits>

#include "geom/binary_tree.hpp"
#include "geom/bvh_widening.hpp"

namespace meniscus::geom {

namespace {

/// Rounds so that the box only grows.
float rounded_down(double x) {
    const auto value = static_cast<float>(x);
    return value <= x ? value : std::nextafter(value, -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace

BuildItem::BuildItem(const Bounds& box, const Vec3& center, std::uint32_t index) {
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = rounded_down(box.low[axis] - center[axis]);
        high[axis] = rounded_up(box.high[axis] - center[axis]);
    }
    low[3] = std::bit_cast<float>(index);
    high[3] = 0.0f;
}

HugeVector<BvhNode> build_bvh(std::vector<BuildItem>& items, std::uint32_t leaf_size) {
    HugeVector<BvhNode> nodes;
    if (items.empty()) return nodes;
    const BinaryTree tree(items, leaf_size);
    Widening(tree).widen(0, nodes);
    nodes.shrink_to_fit();
    return nodes;
}

}  // namespace meniscus::geom
