#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "geom/bvh_builder.hpp"
#include "geom/lanes.hpp"

namespace meniscus::geom {

/// A box in lanes; the fourth is unused.
struct LaneBox {
    Lanes low = Lanes::all(std::numeric_limits<float>::infinity());
    Lanes high = Lanes::all(-std::numeric_limits<float>::infinity());

    static LaneBox of(const BuildItem& item) {
        return {Lanes::load(item.low.data()), Lanes::load(item.high.data())};
    }
    void extend(const LaneBox& other) {
        low = min(low, other.low);
        high = max(high, other.high);
    }
    /// Half its surface.
    float area() const {
        alignas(16) std::array<float, 4> size;
        (high - low).store(size.data());
        return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
};

struct BinaryNode {
    LaneBox box;
    std::uint32_t leaves;  // below it, or 1: it is one
    std::uint32_t next;    // a leaf's number, or the second child's; the first comes just behind
};

/// A binary tree by the surface area heuristic over 16 bins of the boxes' centres (Wald 2007), its
/// nodes in the order of a walk: where a subtree goes follows from how many leaves come before it,
/// so that threads need not agree on anything.
class BinaryTree {
public:
    BinaryTree(std::vector<BuildItem>& items, std::uint32_t leaf_size);

    const BinaryNode& operator[](std::uint32_t i) const { return nodes_[i]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }

private:
    struct Bins;
    struct Split;

    std::uint32_t leaves_of(std::uint32_t items) const {
        return (items + leaf_size_ - 1) / leaf_size_;
    }
    void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth);
    std::uint32_t split(const LaneBox& centers, std::uint32_t begin, std::uint32_t end, int depth);
    void put_lower_first(std::uint32_t begin, std::uint32_t middle, std::uint32_t end, int axis);
    float cost(const LaneBox& box, std::uint32_t count) const;
    Split cheapest_split(const Bins& bins, std::uint32_t begin, std::uint32_t end) const;

    std::vector<BuildItem>& items_;
    std::uint32_t leaf_size_;
    std::vector<BinaryNode> nodes_;
};

}  // namespace meniscus::geom
