#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/bounds.hpp"
#include "geom/ray.hpp"

namespace meniscus::geom {

/// A bounding volume hierarchy over boxes, which must be finite. It hands out the indices of the
/// boxes that a line or a region may meet. Boxes are widened by more than any rounding error along
/// the ray, so that what lies inside one is never missed.
class Bvh {
public:
    Bvh() = default;
    explicit Bvh(std::span<const Bounds> boxes, int leaf_size = 4);

    bool empty() const { return nodes_.empty(); }
    Bounds bounds() const { return empty() ? Bounds{} : nodes_[0].bounds; }
    std::size_t memory_bytes() const {
        return nodes_.size() * sizeof(Node) + order_.size() * sizeof(order_[0]);
    }

    /// The indices of all boxes as the leaves hold them: neighbours in space are neighbours here.
    const std::vector<std::uint32_t>& order() const { return order_; }
    /// From now on box i is the i-th of `order()`: for an owner who has put its own things into
    /// that order.
    void renumber();

    /// Visits boxes that meet the ray's line at t in [0, t_max], the nearer parts of space first.
    /// The visitor, called as visit(index), may lower the `t_max` it was given by reference: what
    /// lies beyond is left out from then on.
    template <class Visit>
    void traverse(const Ray& ray, const double& t_max, Visit&& visit) const {
        walk(ray, 0.0, t_max, visit);
    }
    /// Visits boxes that meet the whole line, behind the origin too, in no particular order.
    template <class Visit>
    void traverse_line(const Ray& ray, Visit&& visit) const {
        const double everywhere = std::numeric_limits<double>::infinity();
        walk(ray, -everywhere, everywhere, visit);
    }
    /// Visits boxes that share a point with `region`.
    template <class Visit>
    void overlapping(const Bounds& region, Visit&& visit) const;

private:
    struct Node {
        Bounds bounds;
        std::uint32_t
            first;  // of its items in `order_`; of an inner node: the first of its two children
        std::uint32_t count;  // 0: an inner node
    };
    /// Deeper trees are not built.
    static constexpr int max_depth = 64;

    struct Builder;

    template <class Visit>
    void walk(const Ray& ray, double t_min, const double& t_max, Visit& visit) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

/// A ray made ready for boxes: its line is thick enough to cover every rounding error of the boxes'
/// contents.
struct BoxRay {
    Vec3 near_side, far_side, inverse;

    BoxRay(const Ray& ray, const Bounds& world);

    /// The part of the line inside the box, as [near, far]; empty when near > far.
    Span inside(const Bounds& box) const {
        const Vec3 a = (box.low - far_side) * inverse, b = (box.high - near_side) * inverse;
        const Vec3 near = glm::min(a, b), far = glm::max(a, b);
        return {glm::max(near.x, glm::max(near.y, near.z)),
                glm::min(far.x, glm::min(far.y, far.z))};
    }
};

template <class Visit>
void Bvh::walk(const Ray& ray, double t_min, const double& t_max, Visit& visit) const {
    if (empty()) return;
    const BoxRay line(ray, nodes_[0].bounds);
    std::array<std::pair<std::uint32_t, double>, max_depth>
        stack;  // node, where the line enters it
    int size = 0;

    const Span all = line.inside(nodes_[0].bounds);
    if (!(all.near <= all.far && all.far >= t_min && all.near <= t_max)) return;
    std::uint32_t index = 0;
    while (true) {
        const Node& node = nodes_[index];
        if (node.count > 0) {
            for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
        } else {
            const Span a = line.inside(nodes_[node.first].bounds);
            const Span b = line.inside(nodes_[node.first + 1].bounds);
            const bool meets_a = a.near <= a.far && a.far >= t_min && a.near <= t_max;
            const bool meets_b = b.near <= b.far && b.far >= t_min && b.near <= t_max;
            if (meets_a && meets_b) {
                const bool a_first = a.near <= b.near;
                stack[size++] =
                    a_first ? std::pair{node.first + 1, b.near} : std::pair{node.first, a.near};
                index = a_first ? node.first : node.first + 1;
                continue;
            }
            if (meets_a || meets_b) {
                index = meets_a ? node.first : node.first + 1;
                continue;
            }
        }
        do {
            if (size == 0) return;
            --size;
        } while (stack[size].second > t_max);
        index = stack[size].first;
    }
}

template <class Visit>
void Bvh::overlapping(const Bounds& region, Visit&& visit) const {
    if (empty()) return;
    std::array<std::uint32_t, max_depth + 1> stack;
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        if (!overlap(node.bounds, region)) continue;
        if (node.count == 0) {
            stack[size++] = node.first;
            stack[size++] = node.first + 1;
        }
        for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
    }
}

}  // namespace meniscus::geom
