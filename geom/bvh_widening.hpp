#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "geom/binary_tree.hpp"
#include "geom/bvh_node.hpp"
#include "geom/huge_pages.hpp"

namespace meniscus::geom {

/// Makes nodes of eight children out of a binary tree's, those of the smallest surface in all: a
/// node is visited as often as its surface says (Ylitie, Karras and Laine 2017, section 3).
class Widening {
public:
    explicit Widening(const BinaryTree& tree) : tree_(tree), surface_(tree.size()) {
        // Children come behind their parents.
        for (std::uint32_t i = tree.size(); i-- > 0;) {
            if (tree[i].leaves == 1) {
                surface_[i].fill(0.0f);
                continue;
            }
            surface_[i][0] = tree[i].box.area() + of_two(i, BvhNode::width).surface;
            for (int most = 2; most <= BvhNode::width; ++most) {
                surface_[i][most - 1] = std::min(surface_[i][most - 2], of_two(i, most).surface);
            }
        }
    }

    /// Of the descendants of `binary`; returns the new node's number.
    std::uint32_t widen(std::uint32_t binary, HugeVector<BvhNode>& nodes) const {
        Children children;
        if (tree_[binary].leaves == 1) {
            children.at[children.count++] = binary;
        } else {
            open(binary, BvhNode::width, children);
        }

        const auto number = static_cast<std::uint32_t>(nodes.size());
        BvhNode node;
        for (auto& [low, high] : node.sides) {
            low.fill(std::numeric_limits<float>::infinity());
            high.fill(-std::numeric_limits<float>::infinity());
        }
        node.child.fill(BvhNode::leaf);
        for (int i = 0; i < children.count; ++i) {
            alignas(16) std::array<float, 4> low, high;
            tree_[children.at[i]].box.low.store(low.data());
            tree_[children.at[i]].box.high.store(high.data());
            for (int axis = 0; axis < 3; ++axis) {
                node.sides[axis][0][i] = low[axis];
                node.sides[axis][1][i] = high[axis];
            }
        }
        nodes.push_back(node);
        for (int i = 0; i < children.count; ++i) {
            const BinaryNode& child = tree_[children.at[i]];
            nodes[number].child[i] =
                child.leaves == 1 ? BvhNode::leaf | child.next : widen(children.at[i], nodes);
        }
        return number;
    }

private:
    struct Children {
        std::array<std::uint32_t, BvhNode::width> at;
        int count = 0;
    };
    /// How many of `most` children go to the first of two, and what surface that makes.
    struct Share {
        float surface = std::numeric_limits<float>::infinity();
        int first = 1;
    };

    Share of_two(std::uint32_t binary, int most) const {
        const auto& first = surface_[binary + 1];
        const auto& second = surface_[tree_[binary].next];
        Share best;
        for (int i = 1; i < most; ++i) {
            const float surface = first[i - 1] + second[most - i - 1];
            if (surface < best.surface) best = {surface, i};
        }
        return best;
    }

    /// Takes children from below `binary`, `most` of them.
    void open(std::uint32_t binary, int most, Children& children) const {
        const Share share = of_two(binary, most);
        take(binary + 1, share.first, children);
        take(tree_[binary].next, most - share.first, children);
    }
    void take(std::uint32_t binary, int most, Children& children) const {
        if (tree_[binary].leaves == 1 || most == 1 ||
            surface_[binary][0] <= of_two(binary, most).surface) {
            children.at[children.count++] = binary;
        } else {
            open(binary, most, children);
        }
    }

    const BinaryTree& tree_;
    /// Of the nodes that a binary node's descendants make as 1, 2, ... 8 children of another one.
    std::vector<std::array<float, BvhNode::width>> surface_;
};

}  // namespace meniscus::geom
