#include "tracer/nesting.hpp"

#include <algorithm>
#include <numeric>

#include "tracer/render_scene.hpp"

namespace meniscus::tracer {
namespace {

using geom::Bounds;
using geom::Vec3;

/// Fewer within each other are as well asked one by one.
constexpr std::uint32_t least_depth = 6;
/// A ray goes into each other's groups by recursion.
constexpr std::uint32_t greatest_depth = 4096;
/// As many pairs as that are looked at, and no more.
constexpr std::size_t most_pairs_per_part = 1024;
/// Groups of so few have no hierarchy.
constexpr std::size_t few_parts = 4;
/// Of the scene's size and its distance from the origin: far beyond all rounding, and what
/// EventFinder takes to be one place (`reach`).
constexpr double margin_share = 1e-5;

/// Whether it may hold others: a ray that sees them sees it, and its list says whether it is
/// inside.
bool may_hold(const Part& part) {
    const bool is_simple = std::holds_alternative<geom::Sphere>(part.shape.shape()) ||
                           std::holds_alternative<geom::Box>(part.shape.shape());
    return part.is_member && !part.inverse && is_simple && part.shape.is_closed() &&
           part.shape.transform().is_identity() && !part.no_image && !part.no_reflection;
}

bool lies_within(const Part& inner, const Part& outer, double margin) {
    const Bounds bounds = inner.shape.bounds().padded(margin);
    const auto* ball = std::get_if<geom::Sphere>(&outer.shape.shape());
    if (!ball)
        return outer.shape.bounds().contains(bounds.low) &&
               outer.shape.bounds().contains(bounds.high);
    const auto* inner_ball = std::get_if<geom::Sphere>(&inner.shape.shape());
    if (inner_ball && inner.shape.transform().is_identity()) {
        return glm::length(inner_ball->center - ball->center) + inner_ball->radius + margin <
               ball->radius;
    }
    const Vec3 farthest =
        glm::max(glm::abs(bounds.low - ball->center), glm::abs(bounds.high - ball->center));
    return glm::length(farthest) < ball->radius;
}

class Finder {
public:
    Finder(const RenderScene& scene, Nesting& nesting)
        : scene_(scene), nesting_(nesting), holder_(scene.parts.size(), outside) {}

    /// False if there is nothing worth while.
    bool run() {
        const Bounds& all = scene_.bvh.bounds();
        nesting_.margin = margin_share * (scene_.size + std::max(geom::max_abs(all.low),
                                                                 geom::max_abs(all.high))) +
                          1000.0 * scene_.contact_tolerance;
        if (!is_deep_somewhere() || !find_holders() || !number_places()) return false;
        make_groups();
        find_alone();
        return true;
    }

private:
    const Part& part(int index) const { return scene_.parts[std::size_t(index)]; }
    Nesting::Place& place(int index) { return nesting_.places[std::size_t(index)]; }
    int& holder(int index) { return holder_[std::size_t(index)]; }

    /// Looks at some of the parts: most scenes are told by that.
    bool is_deep_somewhere() const {
        std::size_t most = 0;
        const std::size_t step = std::max<std::size_t>(scene_.bvh_parts.size() / 1000, 1);
        for (std::size_t i = 0; i < scene_.bvh_parts.size(); i += step) {
            const Vec3 middle = part(scene_.bvh_parts[i]).shape.bounds().center();
            std::size_t around = 0;
            scene_.bvh.overlapping({middle, middle}, [&](std::uint32_t primitive) {
                around += may_hold(part(scene_.bvh_parts[primitive]));
            });
            most = std::max(most, around);
        }
        return most > least_depth;
    }

    /// The smallest that holds each part.
    bool find_holders() {
        std::size_t left = most_pairs_per_part * scene_.bvh_parts.size();
        for (const int inner : scene_.bvh_parts) {
            const Vec3 middle = part(inner).shape.bounds().center();
            double least = geom::infinity;
            bool is_too_much = false;
            scene_.bvh.overlapping({middle, middle}, [&](std::uint32_t primitive) {
                const int outer = scene_.bvh_parts[primitive];
                if (left == 0) is_too_much = true;
                if (outer == inner || left == 0) return;
                --left;
                const double area = part(outer).shape.bounds().area();
                if (area >= least || !may_hold(part(outer)) ||
                    !lies_within(part(inner), part(outer), nesting_.margin))
                    return;
                least = area;
                holder(inner) = outer;
            });
            if (is_too_much) return false;
        }
        return true;
    }

    /// Each part before all that it holds.
    bool number_places() {
        std::vector<std::vector<int>> held(scene_.parts.size());
        std::vector<int> waiting;
        for (const int index : scene_.bvh_parts)
            (holder(index) == outside ? waiting : held[std::size_t(holder(index))])
                .push_back(index);
        nesting_.places.assign(scene_.parts.size(), {});
        std::vector<int> order;
        while (!waiting.empty()) {
            const int index = waiting.back();
            waiting.pop_back();
            order.push_back(index);
            place(index).number = place(index).last = std::uint32_t(order.size());
            place(index).level = holder(index) == outside ? 0 : place(holder(index)).level + 1;
            nesting_.deepest = std::max(nesting_.deepest, place(index).level);
            const auto& inner = held[std::size_t(index)];
            waiting.insert(waiting.end(), inner.begin(), inner.end());
        }
        std::reverse(order.begin(), order.end());
        for (const int index : order) {
            if (holder(index) == outside) continue;
            std::uint32_t& last = place(holder(index)).last;
            last = std::max(last, place(index).last);
        }
        return nesting_.deepest >= least_depth && nesting_.deepest <= greatest_depth;
    }

    void make_groups() {
        nesting_.groups.emplace_back();
        for (const int index : scene_.bvh_parts) {
            int group = 0;
            if (holder(index) != outside) {
                int& held = place(holder(index)).held;
                if (held < 0) {
                    held = int(nesting_.groups.size());
                    nesting_.groups.emplace_back();
                }
                group = held;
            }
            nesting_.groups[std::size_t(group)].parts.push_back(index);
        }
        for (Nesting::Group& group : nesting_.groups) {
            if (group.parts.size() <= few_parts) continue;
            std::vector<Bounds> bounds;
            for (const int index : group.parts) bounds.push_back(part(index).shape.bounds());
            group.bvh = geom::Bvh(bounds);
        }
    }

    bool has_neighbours(int index, const Nesting::Group& group) const {
        const Bounds bounds = part(index).shape.bounds().padded(2.0 * nesting_.margin);
        bool found = false;
        const auto look = [&](int other) {
            found = found || (other != index && overlap(bounds, part(other).shape.bounds()));
        };
        if (group.bvh.empty()) {
            std::ranges::for_each(group.parts, look);
        } else {
            group.bvh.overlapping(bounds, [&](std::uint32_t i) { look(group.parts[i]); });
        }
        return found;
    }

    void find_alone() {
        std::vector<int> order(scene_.bvh_parts);
        std::ranges::sort(order, {}, [&](int index) { return place(index).number; });
        for (const int index : order) {
            const int outer = holder(index);
            const int group = outer == outside ? 0 : place(outer).held;
            place(index).is_alone = (outer == outside || place(outer).is_alone) &&
                                    !has_neighbours(index, nesting_.groups[std::size_t(group)]);
        }
    }

    const RenderScene& scene_;
    Nesting& nesting_;
    std::vector<int> holder_;  // by part
};

}  // namespace

Nesting find_nesting(const RenderScene& scene) {
    Nesting nesting;
    if (scene.bvh_parts.size() <= least_depth || !Finder(scene, nesting).run()) return {};
    return nesting;
}

}  // namespace meniscus::tracer
