#include "geom/bvh.hpp"

#include <algorithm>
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

}  // namespace

/// Splits by the surface area heuristic over 16 bins of the boxes' centres (Wald 2007).
struct Bvh::Builder {
    Bvh& bvh;
    std::span<const Bounds> boxes;
    std::vector<Vec3> centers{};
    std::uint32_t leaf_size;

    void build(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
        Bounds bounds, middles;
        for (std::uint32_t i = begin; i < end; ++i) {
            bounds.extend(boxes[bvh.order_[i]]);
            middles.extend(centers[bvh.order_[i]]);
        }
        const std::uint32_t count = end - begin;
        bvh.nodes_[index] = {bounds, begin, count};
        if (count == 1) return;

        const std::uint32_t middle = split(bounds, middles, begin, end, depth);
        if (middle == end) return;
        const auto children = static_cast<std::uint32_t>(bvh.nodes_.size());
        bvh.nodes_.resize(children + 2);
        bvh.nodes_[index].first = children;
        bvh.nodes_[index].count = 0;
        build(children, begin, middle, depth + 1);
        build(children + 1, middle, end, depth + 1);
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
    nodes_.reserve(boxes.size());
    nodes_.resize(1);
    Builder builder{.bvh = *this, .boxes = boxes, .leaf_size = std::uint32_t(leaf_size)};
    builder.centers.reserve(boxes.size());
    for (const Bounds& box : boxes) builder.centers.push_back(box.center());
    builder.build(0, 0, static_cast<std::uint32_t>(boxes.size()), 0);
    nodes_.shrink_to_fit();
}

void Bvh::renumber() { std::iota(order_.begin(), order_.end(), 0u); }

BoxRay::BoxRay(const Ray& ray, const Bounds& world) {
    // Errors of crossings are a few unit roundoffs of the largest coordinate in play.
    const double magnitude =
        max_abs(ray.origin) + glm::max(max_abs(world.low), max_abs(world.high));
    const Vec3 margin{128.0 * unit_roundoff * magnitude};
    near_side = ray.origin - margin;
    far_side = ray.origin + margin;
    // A direction of 0 would give 0 * infinity; this is as good as 0 and gives large numbers of the
    // right sign.
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        inverse[axis] = glm::abs(d) < 1e-200 ? 1e200 : 1.0 / d;
    }
}

}  // namespace meniscus::geom
