#include "geom/binary_tree.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

namespace meniscus::geom {

namespace {

constexpr int bin_count = 16;
constexpr std::uint32_t parallel_above = 8192;  // items
/// From this depth on every split halves, which ends within 32 more.
constexpr int halve_from = 48;

}  // namespace

struct BinaryTree::Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = 0;
    int bin = 0;  // the last one of the lower half
};
/// Sorts centres into bins along each axis that has an extent.
struct BinaryTree::Bins {
    std::array<float, 3> low, scale;

    int of(const BuildItem& item, int axis) const {
        const auto bin = static_cast<int>((item.middle(axis) - low[axis]) * scale[axis]);
        return std::clamp(bin, 0, bin_count - 1);
    }
};

BinaryTree::BinaryTree(std::vector<BuildItem>& items, std::uint32_t leaf_size)
    : items_(items), leaf_size_(leaf_size) {
    const auto count = static_cast<std::uint32_t>(items.size());
    nodes_.resize(2 * leaves_of(count) - 1);
    build(0, 0, count, 0);
}

void BinaryTree::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth) {
    LaneBox box, centers;
    for (std::uint32_t i = begin; i < end; ++i) {
        const LaneBox item = LaneBox::of(items_[i]);
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
std::uint32_t BinaryTree::split(const LaneBox& centers, std::uint32_t begin, std::uint32_t end,
                                int depth) {
    alignas(16) std::array<float, 4> low, size;
    centers.low.store(low.data());
    (centers.high - centers.low).store(size.data());
    const int widest = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    const std::uint32_t leaves = leaves_of(end - begin);
    const std::uint32_t half = begin + leaves / 2 * leaf_size_;
    if (depth >= halve_from || !(size[widest] > 0.0f)) {
        put_lower_first(begin, half, end, widest);
        return half;
    }
    Bins bins;
    for (int axis = 0; axis < 3; ++axis) {
        bins.low[axis] = low[axis];
        bins.scale[axis] = size[axis] > 0.0f ? bin_count * (1.0f - 0x1p-20f) / size[axis] : 0.0f;
        if (!std::isfinite(bins.scale[axis])) bins.scale[axis] = 0.0f;
    }
    const Split best = cheapest_split(bins, begin, end);
    if (!(best.cost < std::numeric_limits<float>::infinity())) {
        put_lower_first(begin, half, end, widest);
        return half;
    }
    const auto cut =
        std::partition(items_.begin() + begin, items_.begin() + end,
                       [&](const BuildItem& item) { return bins.of(item, best.axis) <= best.bin; });
    const auto lower = static_cast<std::uint32_t>(cut - items_.begin());
    const std::uint32_t lower_leaves =
        std::clamp((lower - begin + leaf_size_ / 2) / leaf_size_, 1u, leaves - 1);
    const std::uint32_t middle = begin + lower_leaves * leaf_size_;
    if (middle < lower) put_lower_first(begin, middle, lower, best.axis);
    if (middle > lower) put_lower_first(lower, middle, end, best.axis);
    return middle;
}

void BinaryTree::put_lower_first(std::uint32_t begin, std::uint32_t middle, std::uint32_t end,
                                 int axis) {
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [axis](const BuildItem& a, const BuildItem& b) {
                         const float x = a.middle(axis), y = b.middle(axis);
                         return x != y ? x < y : a.index() < b.index();
                     });
}

/// A leaf costs the same, however full.
float BinaryTree::cost(const LaneBox& box, std::uint32_t count) const {
    return box.area() * static_cast<float>(leaves_of(count));
}

BinaryTree::Split BinaryTree::cheapest_split(const Bins& bins, std::uint32_t begin,
                                             std::uint32_t end) const {
    std::array<std::array<LaneBox, bin_count>, 3> boxes;
    std::array<std::array<std::uint32_t, bin_count>, 3> counts{};
    for (std::uint32_t i = begin; i < end; ++i) {
        const LaneBox box = LaneBox::of(items_[i]);
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
        LaneBox upper;
        std::uint32_t count = 0;
        for (int i = bin_count - 1; i > 0; --i) {
            upper.extend(boxes[axis][i]);
            count += counts[axis][i];
            upper_count[i - 1] = count;
            upper_cost[i - 1] = count > 0 ? cost(upper, count) : 0.0f;
        }
        LaneBox lower;
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

}  // namespace meniscus::geom
