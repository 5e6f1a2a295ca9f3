#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geom/bvh_builder.hpp"
#include "geom/bvh_line.hpp"
#include "geom/lanes.hpp"

namespace meniscus::geom {

/// A bounding volume hierarchy over boxes, which must be finite. It hands out the indices of the
/// boxes that a line or a region may meet. Boxes are widened by more than any rounding error along
/// the ray, so that what lies inside one is never missed; now and then one is visited that is only
/// nearly met.
class Bvh {
public:
    Bvh() = default;
    explicit Bvh(std::span<const Bounds> boxes, std::uint32_t leaf_size = 1);

    bool empty() const { return nodes_.empty(); }
    const Bounds& bounds() const { return bounds_; }
    std::size_t memory_bytes() const {
        return nodes_.size() * sizeof(BvhNode) + order_.size() * sizeof(order_[0]);
    }

    /// From now on a box's index is its place in the hierarchy, so that what is visited together
    /// can stand together in memory. Returns which box stands where.
    std::vector<std::uint32_t> renumber();

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
    void overlapping(const Bounds& region, Visit&& visit) const {
        if (!empty() && overlap(region, bounds_)) select<false>(region, visit);
    }
    /// Visits boxes that hold all of `region`, and now and then one that nearly does.
    template <class Visit>
    void holding(const Bounds& region, Visit&& visit) const {
        if (!empty()) select<true>(region, visit);
    }

private:
    template <bool holds, class Visit>
    void select(const Bounds& region, Visit& visit) const;
    template <class Visit>
    void walk(const Ray& ray, double t_min, const double& t_max, Visit& visit) const;
    template <class Visit>
    void visit_leaf(std::uint32_t child, Visit& visit) const {
        const std::uint32_t first = (child ^ BvhNode::leaf) * leaf_size_;
        const std::uint32_t last = std::min(first + leaf_size_, size_);
        for (std::uint32_t i = first; i < last; ++i) visit(order_.empty() ? i : order_[i]);
    }

    HugeVector<BvhNode> nodes_;
    std::vector<std::uint32_t> order_;  // of the boxes, leaf by leaf; empty: they stand in it
    std::uint32_t size_ = 0, leaf_size_ = 1;
    Bounds bounds_;
    BvhFrame frame_;
};

/// Which children the line meets between `from` and `to`: bit i for child i, and where it enters
/// them.
inline unsigned meets(const BvhLine& line, const BvhNode& node, float from, float to, float* near) {
    unsigned met = 0;
    for (int half = 0; half < BvhNode::width; half += 4) {
        Lanes enter = Lanes::all(from), leave = Lanes::all(to);
        for (int axis = 0; axis < 3; ++axis) {
            const auto& sides = node.sides[axis];
            const float* first = sides[line.backwards[axis]].data() + half;
            const float* last = sides[!line.backwards[axis]].data() + half;
            const Lanes inverse = Lanes::all(line.inverse[axis]);
            enter = max((Lanes::load(first) - Lanes::all(line.near_side[axis])) * inverse, enter);
            leave = min((Lanes::load(last) - Lanes::all(line.far_side[axis])) * inverse, leave);
        }
        enter.store(near + half);
        met |= at_most(enter, leave) << half;
    }
    return met;
}

template <class Visit>
void Bvh::walk(const Ray& ray, double t_min, const double& t_max, Visit& visit) const {
    if (empty()) return;
    const BvhLine line(frame_, ray);
    const float from = line.lower(t_min);
    double known_max = t_max;
    float to = line.upper(t_max);
    BvhStack stack;
    int size = 0;
    stack[size++] = {0, from};
    while (size > 0) {
        const BvhEntry entry = stack[--size];
        if (t_max != known_max) {
            known_max = t_max;
            to = line.upper(t_max);
        }
        if (entry.near > to) continue;
        if (entry.child & BvhNode::leaf) {
            visit_leaf(entry.child, visit);
            continue;
        }
        const BvhNode& node = nodes_[entry.child];
        alignas(16) std::array<float, BvhNode::width> near;
        unsigned met = meets(line, node, from, to, near.data());
        // The nearest child goes on top of the stack.
        for (const int bottom = size; met != 0; met &= met - 1) {
            const int child = std::countr_zero(met);
            int place = size++;
            for (; place > bottom && stack[place - 1].near < near[child]; --place) {
                stack[place] = stack[place - 1];
            }
            stack[place] = {node.child[child], near[child]};
            // What waits in memory is here when its turn comes.
            if (!(node.child[child] & BvhNode::leaf)) fetch_ahead(nodes_[node.child[child]]);
        }
    }
}

template <bool holds, class Visit>
void Bvh::select(const Bounds& region, Visit& visit) const {
    const Bounds seen{region.low - frame_.center, region.high - frame_.center};
    BvhStack stack;
    int size = 0;
    stack[size++] = {0, 0.0f};
    while (size > 0) {
        const BvhEntry entry = stack[--size];
        if (entry.child & BvhNode::leaf) {
            visit_leaf(entry.child, visit);
            continue;
        }
        const BvhNode& node = nodes_[entry.child];
        for (int child = 0; child < BvhNode::width; ++child) {
            bool is_visited = true;
            for (int axis = 0; axis < 3; ++axis) {
                const auto low = node.sides[axis][0][child], high = node.sides[axis][1][child];
                is_visited &= holds ? low <= seen.low[axis] && high >= seen.high[axis]
                                    : low <= seen.high[axis] && high >= seen.low[axis];
            }
            if (is_visited) stack[size++] = {node.child[child], 0.0f};
        }
    }
}

}  // namespace meniscus::geom
