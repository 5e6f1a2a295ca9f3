#include "geom/bvh_builder.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/lanes.hpp"

namespace meniscus::geom {

namespace {

constexpr int bin_count = 16;
constexpr std::uint32_t parallel_above = 8192;  // items
/// From this depth on every split halves, which ends within 32 more.
constexpr int halve_from = 48;

/// Rounds so that the box only grows.
float rounded_down(double x) {
    const auto value = static_cast<float>(x);
    return value <= x ? value : std::nextafter(value, -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) { return -rounded_down(-x); }

/// A box in lanes; the fourth is unused.
struct Box {
    Lanes low = Lanes::all(std::numeric_limits<float>::infinity());
    Lanes high = Lanes::all(-std::numeric_limits<float>::infinity());

    static Box of(const BuildItem& item) {
        return {Lanes::load(item.low.data()), Lanes::load(item.high.data())};
    }
    void extend(const Box& other) {
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
    Box box;
    std::uint32_t leaves;  // below it, or 1: it is one
    std::uint32_t next;    // a leaf's number, or the second child's; the first comes just behind
};

/// A binary tree by the surface area heuristic over 16 bins of the boxes' centres (Wald 2007), its
/// nodes in the order of a walk: where a subtree goes follows from how many leaves come before it,
/// so that threads need not agree on anything.
class BinaryTree {
public:
    BinaryTree(std::vector<BuildItem>& items, std::uint32_t leaf_size)
        : items_(items), leaf_size_(leaf_size) {
        const auto count = static_cast<std::uint32_t>(items.size());
        nodes_.resize(2 * leaves_of(count) - 1);
        build(0, 0, count, 0);
    }

    const BinaryNode& operator[](std::uint32_t i) const { return nodes_[i]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }

private:
    struct Split {
        float cost = std::numeric_limits<float>::infinity();
        int axis = 0;
        int bin = 0;  // the last one of the lower half
    };
    /// Sorts centres into bins along each axis that has an extent.
    struct Bins {
        std::array<float, 3> low, scale;

        int of(const BuildItem& item, int axis) const {
            const auto bin = static_cast<int>((item.middle(axis) - low[axis]) * scale[axis]);
            return std::clamp(bin, 0, bin_count - 1);
        }
    };

    std::uint32_t leaves_of(std::uint32_t items) const {
        return (items + leaf_size_ - 1) / leaf_size_;
    }

    void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth) {
        Box box, centers;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Box item = Box::of(items_[i]);
            box.extend(item);
            const Lanes middle = item.low + item.high;
            centers.extend({middle, middle});
        }
        const std::uint32_t leaves = leaves_of(end - begin);
        nodes_[node] = {box, leaves, begin / leaf_size_};
        if (leaves == 1) return;

        const std::uint32_t middle = split(centers, begin, end, depth);
        const std::uint32_t second = node + 2 * leaves_of(middle - begin);
        nodes_[node].next = second;
        const auto first_child = [&] { build(node + 1, begin, middle, depth + 1); };
        const auto second_child = [&] { build(second, middle, end, depth + 1); };
        if (end - begin > parallel_above) {
            tbb::parallel_invoke(first_child, second_child);
        } else {
            first_child();
            second_child();
        }
    }

    /// Rearranges the items and returns where the second child begins: at a multiple of the leaf's
    /// size, so that all leaves are full.
    std::uint32_t split(const Box& centers, std::uint32_t begin, std::uint32_t end, int depth) {
        alignas(16) std::array<float, 4> low, size;
        centers.low.store(low.data());
        (centers.high - centers.low).store(size.data());
        const int widest = size[0] >= size[1] && size[0] >= size[2] ? 0
                           : size[1] >= size[2]                     ? 1
                                                                    : 2;
        const std::uint32_t leaves = leaves_of(end - begin);
        const std::uint32_t half = begin + leaves / 2 * leaf_size_;
        if (depth >= halve_from || !(size[widest] > 0.0f)) {
            put_lower_first(begin, half, end, widest);
            return half;
        }
        Bins bins;
        for (int axis = 0; axis < 3; ++axis) {
            bins.low[axis] = low[axis];
            bins.scale[axis] =
                size[axis] > 0.0f ? bin_count * (1.0f - 0x1p-20f) / size[axis] : 0.0f;
            if (!std::isfinite(bins.scale[axis])) bins.scale[axis] = 0.0f;
        }
        const Split best = cheapest_split(bins, begin, end);
        if (!(best.cost < std::numeric_limits<float>::infinity())) {
            put_lower_first(begin, half, end, widest);
            return half;
        }
        const auto cut = std::partition(
            items_.begin() + begin, items_.begin() + end,
            [&](const BuildItem& item) { return bins.of(item, best.axis) <= best.bin; });
        const auto lower = static_cast<std::uint32_t>(cut - items_.begin());
        const std::uint32_t lower_leaves =
            std::clamp((lower - begin + leaf_size_ / 2) / leaf_size_, 1u, leaves - 1);
        const std::uint32_t middle = begin + lower_leaves * leaf_size_;
        if (middle < lower) put_lower_first(begin, middle, lower, best.axis);
        if (middle > lower) put_lower_first(lower, middle, end, best.axis);
        return middle;
    }

    void put_lower_first(std::uint32_t begin, std::uint32_t middle, std::uint32_t end, int axis) {
        std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                         [axis](const BuildItem& a, const BuildItem& b) {
                             const float x = a.middle(axis), y = b.middle(axis);
                             return x != y ? x < y : a.index() < b.index();
                         });
    }

    /// A leaf costs the same, however full.
    float cost(const Box& box, std::uint32_t count) const {
        return box.area() * static_cast<float>(leaves_of(count));
    }

    Split cheapest_split(const Bins& bins, std::uint32_t begin, std::uint32_t end) const {
        std::array<std::array<Box, bin_count>, 3> boxes;
        std::array<std::array<std::uint32_t, bin_count>, 3> counts{};
        for (std::uint32_t i = begin; i < end; ++i) {
            const Box box = Box::of(items_[i]);
            for (int axis = 0; axis < 3; ++axis) {
                const int bin = bins.of(items_[i], axis);
                boxes[axis][bin].extend(box);
                ++counts[axis][bin];
            }
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (bins.scale[axis] == 0.0f) continue;
            std::array<float, bin_count> upper_cost;
            std::array<std::uint32_t, bin_count> upper_count;
            Box upper;
            std::uint32_t count = 0;
            for (int i = bin_count - 1; i > 0; --i) {
                upper.extend(boxes[axis][i]);
                count += counts[axis][i];
                upper_count[i - 1] = count;
                upper_cost[i - 1] = count > 0 ? cost(upper, count) : 0.0f;
            }
            Box lower;
            count = 0;
            for (int i = 0; i + 1 < bin_count; ++i) {
                lower.extend(boxes[axis][i]);
                count += counts[axis][i];
                if (count == 0 || upper_count[i] == 0) continue;
                const float both = cost(lower, count) + upper_cost[i];
                if (both < best.cost) best = {both, axis, i};
            }
        }
        return best;
    }

    std::vector<BuildItem>& items_;
    std::uint32_t leaf_size_;
    std::vector<BinaryNode> nodes_;
};

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
