#include <algorithm>
#include <cmath>

#include "tracer/next_event.hpp"

namespace meniscus::tracer {
namespace {

struct NearestHit {
    double t = geom::infinity;
    int part = outside;
    geom::Face face = geom::no_face;
    bool entering = false;
};

}  // namespace

/// The paper's own method, as it stands there (Schmidt and Budge 2002, section 3): at each hit the
/// solid is toggled in the list; where the solid that is there does not change, the ray is cast
/// again from just behind the hit. What is nearer than an epsilon is not seen. With
/// InteriorMode::off there is no list: each surface bounds its own solid against the outside.
bool EventFinder::recast(TracedRay& ray, double t_max, Event& event) {
    const bool keeps_list = options_.interior == InteriorMode::recast;
    TracedRay leg = ray;
    double travelled = 0.0;
    geom::Crossings crossings;

    while (true) {
        ++statistics_.casts;
        ++stamp_;
        NearestHit nearest;
        // Nor what is nearer than the origin's rounding: a cast from there would never get on.
        const double epsilon = std::max(options_.recast_epsilon * scene_.size,
                                        0x1p-50 * geom::max_abs(leg.ray.origin));
        double limit = t_max - travelled;
        const auto see = [&](int index) {
            if (visited_[index] == stamp_) return;
            visited_[index] = stamp_;
            const Part& part = scene_.parts[index];
            if (!is_visible(part, ray.kind)) return;
            crossings.clear();
            if (part.shape.is_closed() && part.shape.is_convex()) {
                const geom::Interval interval = part.shape.interval(leg.ray, geom::no_face);
                if (!interval.hit) return;
                crossings.push_back({interval.t0, interval.face0, true});
                crossings.push_back({interval.t1, interval.face1, false});
            } else {
                geom::Search search;
                search.from = epsilon;
                search.to = limit;
                search.entering_ends = search.leaving_ends = true;
                part.shape.crossings(leg.ray, search, crossings);
            }
            for (const geom::Crossing& crossing : crossings) {
                if (!(crossing.t > epsilon) || crossing.t > limit) continue;
                if (crossing.t == geom::infinity) continue;
                if (crossing.t < nearest.t || (crossing.t == nearest.t && index < nearest.part)) {
                    nearest = {crossing.t, index, crossing.face, crossing.entering != part.inverse};
                    limit = crossing.t;
                }
                break;
            }
        };
        for (const int part : scene_.unbounded) see(part);
        scene_.bvh.traverse(leg.ray, limit,
                            [&](std::uint32_t primitive) { see(scene_.bvh_parts[primitive]); });
        if (nearest.part == outside) {
            ray.interior = leg.interior;
            if (keeps_list && t_max == geom::infinity) check_escape(ray);
            return false;
        }

        const Part& part = scene_.parts[nearest.part];
        const Offer offer{nearest.t, nearest.part, nearest.face, nearest.entering};
        InteriorList before = leg.interior, after = leg.interior;
        if (part.is_member && keeps_list) {
            if (before.inside(nearest.part)) {
                after.leave(nearest.part);
            } else {
                after.enter(nearest.part);
            }
        } else if (part.is_member) {
            before = after = InteriorList{};
            (nearest.entering ? after : before).enter(nearest.part);
        }
        const int solid_before = before.top_solid(scene_), solid_after = after.top_solid(scene_);
        const bool is_true = !part.is_member || solid_before != solid_after;
        if (record)
            record->push_back({travelled + nearest.t, nearest.part, nearest.entering, is_true});
        if (is_true) {
            ++statistics_.true_crossings;
            event.before = before;
            event.after = after;
            make_event(leg, nearest.t, offer, solid_before, solid_after, event);
            event.t = travelled + nearest.t;
            const int top_after = after.top(scene_);
            if (part.is_member && top_after != outside && scene_.parts[top_after].is_opaque)
                event.skin = top_after;
            ray.interior = before;
            return true;
        }
        ++statistics_.false_crossings;
        leg.interior = after;
        leg.ray.origin = leg.ray.at(nearest.t);
        leg.ray.origin_error = geom::Vec3{0.0};
        travelled += nearest.t;
    }
}

}  // namespace meniscus::tracer
