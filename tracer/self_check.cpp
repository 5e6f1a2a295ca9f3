#include <cmath>

#include "tracer/next_event.hpp"

namespace meniscus::tracer {

/// Far away, a ray is inside of unbounded solids only.
void EventFinder::check_escape(const TracedRay& ray) {
    for (const InteriorList::Member& member : ray.interior) {
        const Part& part = scene_.parts[member.part];
        if (part.inverse || !part.shape.bounds().is_finite()) continue;
        statistics_.count_leak({std::size_t(part.object), "not empty at infinity", ray.ray.origin});
    }
}

/// Asks, halfway along the segment that ends at `t`, which solid is there, and compares with the
/// list.
void EventFinder::check_midpoint(const TracedRay& ray, double t) {
    if (t == geom::infinity || t <= 0.0) return;
    const geom::Vec3 middle = ray.ray.at(0.5 * t);
    const int listed = ray.interior.top_solid(scene_);
    double best_priority = -geom::infinity;
    bool tie = false;
    int there = outside;
    const auto ask = [&](int index) {
        const Part& part = scene_.parts[index];
        if (!part.is_member || !is_visible(part, ray.kind)) return;
        if (part.shape.contains(middle) == part.inverse) return;
        if (part.priority > best_priority) {
            best_priority = part.priority;
            there = part.solid;
            tie = false;
        } else if (part.priority == best_priority && part.solid != there) {
            tie = true;
        }
    };
    for (const int part : scene_.unbounded) ask(part);
    scene_.bvh.overlapping({middle, middle},
                           [&](std::uint32_t primitive) { ask(scene_.bvh_parts[primitive]); });
    if (tie || there == listed) return;
    // Within rounding of a surface either answer is right.
    for (const Offer& offer : found_) {
        const double distance = std::abs(offer.t - 0.5 * t);
        if (distance <= 1e-6 * offers_.magnitude(ray, offer.part, offer.t)) return;
    }
    if (t <= 1e-6 * (geom::max_abs(ray.ray.origin) + t)) return;
    const int blamed = there != outside ? there : listed;
    std::size_t object = 0;
    for (const Part& part : scene_.parts) {
        if (part.solid == blamed) object = std::size_t(part.object);
    }
    statistics_.count_leak({object, "wrong medium", middle});
}

}  // namespace meniscus::tracer
