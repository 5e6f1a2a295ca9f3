#include "geom/bvh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace meniscus::geom {

namespace {

constexpr int bin_count = 16;
constexpr double cost_of_node = 1.0, cost_of_item = 1.0;

struct Bin {
    Bounds bounds;
    std::uint32_t count = 0;
};

struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    int bin = 0;  // the last one of the lower half
};

/// Rounds so that the box only grows.
float rounded_down(double x) {
    const auto value = static_cast<float>(x);
    return value <= x ? value : std::nextafter(value, -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace

/// Builds a binary tree by the surface area heuristic over 16 bins of the boxes' centres (Wald
/// 2007), then makes nodes of four children of it.
struct Bvh::Builder {
    struct BinaryNode {
        Bounds bounds;
        std::uint32_t first;  // of its items; of an inner node: the first of its two children
        std::uint32_t count;  // 0: an inner node
    };

    Bvh& bvh;
    std::span<const Bounds> boxes;
    std::uint32_t leaf_size;
    std::vector<Vec3> centers{};
    std::vector<BinaryNode> tree{};

    void build(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
        Bounds bounds, middles;
        for (std::uint32_t i = begin; i < end; ++i) {
            bounds.extend(boxes[bvh.order_[i]]);
            middles.extend(centers[bvh.order_[i]]);
        }
        const std::uint32_t count = end - begin;
        tree[index] = {bounds, begin, count};
        if (count == 1) return;

        const std::uint32_t middle = split(bounds, middles, begin, end, depth);
        if (middle == end) return;
        const auto children = static_cast<std::uint32_t>(tree.size());
        tree.resize(children + 2);
        tree[index].first = children;
        tree[index].count = 0;
        build(children, begin, middle, depth + 1);
        build(children + 1, middle, end, depth + 1);
    }

    /// Makes a node of the binary node's descendants, always opening the one with the largest
    /// surface, and returns its number.
    std::uint32_t widen(std::uint32_t binary) {
        std::array<std::uint32_t, 4> children{binary};
        int count = 1;
        while (count < 4) {
            int widest = -1;
            for (int i = 0; i < count; ++i) {
                if (tree[children[i]].count > 0) continue;
                if (widest < 0 ||
                    tree[children[i]].bounds.area() > tree[children[widest]].bounds.area())
                    widest = i;
            }
            if (widest < 0) break;
            const std::uint32_t first = tree[children[widest]].first;
            children[widest] = first;
            children[count++] = first + 1;
        }

        const auto number = static_cast<std::uint32_t>(bvh.nodes_.size());
        const float infinite = std::numeric_limits<float>::infinity();
        Node node{};
        for (int axis = 0; axis < 3; ++axis) {
            node.low[axis].fill(infinite);
            node.high[axis].fill(-infinite);
            for (int i = 0; i < count; ++i) {
                const Bounds& box = tree[children[i]].bounds;
                node.low[axis][i] = rounded_down(box.low[axis] - bvh.center_[axis]);
                node.high[axis][i] = rounded_up(box.high[axis] - bvh.center_[axis]);
            }
        }
        bvh.nodes_.push_back(node);
        for (int i = 0; i < count; ++i) {
            const BinaryNode& child = tree[children[i]];
            const std::uint32_t first = child.count > 0 ? child.first : widen(children[i]);
            bvh.nodes_[number].first[i] = first;
            bvh.nodes_[number].count[i] = static_cast<std::uint16_t>(child.count);
        }
        return number;
    }

    /// Rearranges the items and returns where the second child begins, or `end` for a leaf.
    std::uint32_t split(const Bounds& bounds, const Bounds& middles, std::uint32_t begin,
                        std::uint32_t end, int depth) {
        const std::uint32_t count = end - begin;
        // Halving from here on keeps the depth within max_depth for any 32-bit count.
        if (depth < max_depth - 34) {
            const Split best = cheapest_split(middles, begin, end);
            const double leaf = cost_of_item * count;
            const double inner = cost_of_node + cost_of_item * best.cost / bounds.area();
            if (count <= leaf_size && !(inner < leaf)) return end;
            if (best.cost < std::numeric_limits<double>::infinity()) {
                const auto cut = std::partition(
                    bvh.order_.begin() + begin, bvh.order_.begin() + end,
                    [&](std::uint32_t i) { return bin_of(middles, best.axis, i) <= best.bin; });
                return static_cast<std::uint32_t>(cut - bvh.order_.begin());
            }
        }
        if (count <= leaf_size) return end;
        const Vec3 size = middles.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto first = bvh.order_.begin() + begin, middle = first + count / 2;
        std::nth_element(first, middle, bvh.order_.begin() + end,
                         [&](auto a, auto b) { return centers[a][axis] < centers[b][axis]; });
        return begin + count / 2;
    }

    int bin_of(const Bounds& middles, int axis, std::uint32_t item) const {
        const double low = middles.low[axis], size = middles.high[axis] - low;
        const int bin = static_cast<int>((centers[item][axis] - low) / size * bin_count);
        return std::clamp(bin, 0, bin_count - 1);
    }

    Split cheapest_split(const Bounds& middles, std::uint32_t begin, std::uint32_t end) const {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(middles.high[axis] > middles.low[axis])) continue;
            std::array<Bin, bin_count> bins;
            for (std::uint32_t i = begin; i < end; ++i) {
                Bin& bin = bins[bin_of(middles, axis, bvh.order_[i])];
                bin.bounds.extend(boxes[bvh.order_[i]]);
                ++bin.count;
            }
            std::array<double, bin_count> upper_cost{};
            Bin upper;
            for (int i = bin_count - 1; i > 0; --i) {
                upper.bounds.extend(bins[i].bounds);
                upper.count += bins[i].count;
                upper_cost[i - 1] = upper.count > 0 ? upper.count * upper.bounds.area() : -1.0;
            }
            Bin lower;
            for (int i = 0; i + 1 < bin_count; ++i) {
                lower.bounds.extend(bins[i].bounds);
                lower.count += bins[i].count;
                if (lower.count == 0 || upper_cost[i] < 0.0) continue;
                const double cost = lower.count * lower.bounds.area() + upper_cost[i];
                if (cost < best.cost) best = {cost, axis, i};
            }
        }
        return best;
    }
};

Bvh::Bvh(std::span<const Bounds> boxes, int leaf_size) : order_(boxes.size()) {
    if (boxes.empty()) return;
    std::iota(order_.begin(), order_.end(), 0u);
    Builder builder{.bvh = *this, .boxes = boxes, .leaf_size = std::uint32_t(leaf_size)};
    builder.centers.reserve(boxes.size());
    for (const Bounds& box : boxes) builder.centers.push_back(box.center());
    builder.tree.reserve(boxes.size());
    builder.tree.resize(1);
    builder.build(0, 0, static_cast<std::uint32_t>(boxes.size()), 0);
    bounds_ = builder.tree[0].bounds;
    center_ = bounds_.center();
    builder.widen(0);
    nodes_.shrink_to_fit();
}

void Bvh::renumber() { std::iota(order_.begin(), order_.end(), 0u); }

Bvh::Line::Line(const Bvh& bvh, const Ray& ray) {
    const double dd = glm::dot(ray.direction, ray.direction);
    const Vec3 from_center = ray.from(bvh.center_);
    shift_ = -glm::dot(from_center, ray.direction) / dd;
    const Vec3 origin = from_center + shift_ * ray.direction;

    // Errors of crossings are a few double roundoffs of the largest coordinate in play; those in
    // here, of the offset from the centre.
    const Vec3 reach = 0.5 * bvh.bounds_.size();
    const double far =
        max_abs(ray.origin) + glm::max(max_abs(bvh.bounds_.low), max_abs(bvh.bounds_.high));
    const double margin =
        128.0 * unit_roundoff * far + 0x1p-20 * (max_abs(reach) + max_abs(origin));
    slack_ = static_cast<float>(margin / glm::sqrt(dd));
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis], size = glm::sqrt(dd);
        backwards_[axis] = d < 0.0;
        // A direction of 0 would give 0 * infinity; a tiny one is as good and gives large numbers
        // of the right sign.
        inverse_[axis] = static_cast<float>(glm::abs(d) < 1e-18 * size ? 1e18 / size : 1.0 / d);
        const double sign = d < 0.0 ? -1.0 : 1.0;
        near_side_[axis] = static_cast<float>(origin[axis] + sign * margin);
        far_side_[axis] = static_cast<float>(origin[axis] - sign * margin);
    }
}

}  // namespace meniscus::geom
