#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geom/bounds.hpp"
#include "geom/lanes.hpp"
#include "geom/ray.hpp"

namespace meniscus::geom {

/// A bounding volume hierarchy over boxes, which must be finite. It hands out the indices of the
/// boxes that a line or a region may meet. Boxes are widened by more than any rounding error along
/// the ray, so that what lies inside one is never missed; now and then one is visited that is only
/// nearly met.
class Bvh {
public:
    Bvh() = default;
    explicit Bvh(std::span<const Bounds> boxes, int leaf_size = 4);

    bool empty() const { return nodes_.empty(); }
    const Bounds& bounds() const { return bounds_; }
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
    /// The boxes of up to four children, seen from `center_`, rounded outwards. Those of children
    /// that are not there are empty.
    struct alignas(16) Node {
        std::array<std::array<float, 4>, 3> low, high;  // [axis][child]
        std::array<std::uint32_t, 4> first;             // item of a leaf in `order_`, or a node
        std::array<std::uint16_t, 4> count;             // of a leaf's items; 0 for a node
    };
    struct Entry {
        std::uint32_t first, count;
        float near;
    };
    class Line;
    struct Builder;

    /// Deeper trees are not built.
    static constexpr int max_depth = 64;
    using Stack = std::array<Entry, 3 * max_depth + 4>;

    template <class Visit>
    void walk(const Ray& ray, double t_min, const double& t_max, Visit& visit) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    Bounds bounds_;
    Vec3 center_{0.0};
};

/// A ray made ready for boxes. Its parameter starts at the point of its line nearest to the boxes'
/// centre, so that single precision does, from any distance; and its line is thick enough to cover
/// every rounding error, here and of what is in the boxes.
class Bvh::Line {
public:
    Line(const Bvh& bvh, const Ray& ray);

    /// A little more than t, as a parameter of this line.
    float upper(double t) const {
        const auto value = static_cast<float>(t - shift_);
        return value + (value < 0.0f ? -value : value) * 0x1p-21f + slack_;
    }
    float lower(double t) const {
        const auto value = static_cast<float>(t - shift_);
        return value - (value < 0.0f ? -value : value) * 0x1p-21f - slack_;
    }

    /// Which children the line meets between `from` and `to`: bit i for child i, and where it
    /// enters them.
    unsigned meets(const Node& node, float from, float to, float* near) const {
        Lanes enter = Lanes::all(from), leave = Lanes::all(to);
        for (int axis = 0; axis < 3; ++axis) {
            // For a line that runs down an axis, the high side comes first.
            const auto& first = backwards_[axis] ? node.high[axis] : node.low[axis];
            const auto& last = backwards_[axis] ? node.low[axis] : node.high[axis];
            const Lanes inverse = Lanes::all(inverse_[axis]);
            enter =
                max((Lanes::load(first.data()) - Lanes::all(near_side_[axis])) * inverse, enter);
            leave = min((Lanes::load(last.data()) - Lanes::all(far_side_[axis])) * inverse, leave);
        }
        enter.store(near);
        return at_most(enter, leave);
    }

private:
    double shift_;
    float slack_;
    std::array<float, 3> near_side_, far_side_, inverse_;
    std::array<bool, 3> backwards_;
};

template <class Visit>
void Bvh::walk(const Ray& ray, double t_min, const double& t_max, Visit& visit) const {
    if (empty()) return;
    const Line line(*this, ray);
    const float from = line.lower(t_min);
    double known_max = t_max;
    float to = line.upper(t_max);
    Stack stack;
    int size = 0;
    stack[size++] = {0, 0, from};
    while (size > 0) {
        const Entry entry = stack[--size];
        if (t_max != known_max) {
            known_max = t_max;
            to = line.upper(t_max);
        }
        if (entry.near > to) continue;
        for (std::uint32_t i = 0; i < entry.count; ++i) visit(order_[entry.first + i]);
        if (entry.count > 0) continue;

        const Node& node = nodes_[entry.first];
        alignas(16) std::array<float, 4> near;
        unsigned met = line.meets(node, from, to, near.data());
        // The nearest child goes on top of the stack.
        for (const int bottom = size; met != 0; met &= met - 1) {
            const int child = std::countr_zero(met);
            int place = size++;
            for (; place > bottom && stack[place - 1].near < near[child]; --place) {
                stack[place] = stack[place - 1];
            }
            stack[place] = {node.first[child], node.count[child], near[child]};
        }
    }
}

template <class Visit>
void Bvh::overlapping(const Bounds& region, Visit&& visit) const {
    if (empty() || !overlap(region, bounds_)) return;
    const Bounds seen{region.low - center_, region.high - center_};
    Stack stack;
    int size = 0;
    stack[size++] = {0, 0, 0.0f};
    while (size > 0) {
        const Entry entry = stack[--size];
        for (std::uint32_t i = 0; i < entry.count; ++i) visit(order_[entry.first + i]);
        if (entry.count > 0) continue;
        const Node& node = nodes_[entry.first];
        for (int child = 0; child < 4; ++child) {
            bool apart = false;
            for (int axis = 0; axis < 3; ++axis) {
                apart |= !(node.low[axis][child] <= seen.high[axis] &&
                           node.high[axis][child] >= seen.low[axis]);
            }
            if (!apart) stack[size++] = {node.first[child], node.count[child], 0.0f};
        }
    }
}

}  // namespace meniscus::geom
