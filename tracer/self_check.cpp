#include <algorithm>
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

/// Asks at inner points of the segment that ends at `t` which solid is there: halfway, and in the
/// middle of its way through the bounds of a few parts, where a crossing that was missed would
/// show.
void EventFinder::check_segment(const TracedRay& ray, double t) {
    if (t <= 0.0) return;
    if (t != geom::infinity) check_medium(ray, t, 0.5 * t);
    double end = t;
    int asked = 0;
    scene_.bvh.traverse(ray.ray, end, [&](std::uint32_t primitive) {
        if (++asked == 8) end = -1.0;  // enough: each point asks every solid around it
        const geom::Bounds& bounds = scene_.parts[scene_.bvh_parts[primitive]].shape.bounds();
        double near = 0.0, far = t;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = ray.ray.direction[axis], o = ray.ray.origin[axis];
            if (d == 0.0) continue;
            const double a = (bounds.low[axis] - o) / d, b = (bounds.high[axis] - o) / d;
            near = std::max(near, std::min(a, b));
            far = std::min(far, std::max(a, b));
        }
        // Not just halfway: many a scene has its faces there.
        if (near < far) check_medium(ray, t, near + 0.4877 * (far - near));
    });
}

/// The solid at a point, by position alone; nothing where solids tie.
std::optional<int> EventFinder::solid_at(const geom::Vec3& p, RayKind kind) const {
    double best_priority = -geom::infinity;
    bool tie = false;
    int there = outside;
    const auto ask = [&](int index) {
        const Part& part = scene_.parts[index];
        if (!part.is_member || !is_visible(part, kind)) return;
        if (part.shape.contains(p) == part.inverse) return;
        if (part.priority > best_priority) {
            best_priority = part.priority;
            there = part.solid;
            tie = false;
        } else if (part.priority == best_priority && part.solid != there) {
            tie = true;
        }
    };
    for (const int part : scene_.unbounded) ask(part);
    scene_.bvh.overlapping({p, p},
                           [&](std::uint32_t primitive) { ask(scene_.bvh_parts[primitive]); });
    if (tie) return std::nullopt;
    return there;
}

/// Whether that solid may be the one at p, if each surface within rounding of p may be on either
/// side of it.
bool EventFinder::may_be_at(const geom::Vec3& p, double rounding, int solid, RayKind kind) const {
    bool is_possible = solid == outside;
    double priority = -geom::infinity, certain = -geom::infinity;
    const auto ask = [&](int index) {
        const Part& part = scene_.parts[index];
        if (!part.is_member || !is_visible(part, kind)) return;
        int inside = 0;
        for (int i = 0; i < 27; ++i) {
            const geom::Vec3 step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
            inside += part.shape.contains(p + rounding * step) != part.inverse;
        }
        if (part.solid == solid) {
            is_possible = is_possible || inside > 0;
            priority = part.priority;
        } else if (inside == 27) {
            certain = std::max(certain, part.priority);
        }
    };
    for (const int part : scene_.unbounded) ask(part);
    scene_.bvh.overlapping(geom::Bounds{p, p}.padded(2.0 * rounding),
                           [&](std::uint32_t primitive) { ask(scene_.bvh_parts[primitive]); });
    return is_possible && certain <= priority;
}

/// Compares the solid at `at`, by position alone, with the list; within rounding of a surface
/// either answer is right.
void EventFinder::check_medium(const TracedRay& ray, double t, double at) {
    const geom::Vec3 p = ray.ray.at(at);
    const int listed = ray.interior.top_solid(scene_);
    const auto asked = solid_at(p, ray.kind);
    if (!asked || *asked == listed) return;
    const int there = *asked;
    for (const Offer& offer : found_) {
        const double distance = std::abs(offer.t - at);
        if (distance <= 1e-6 * offers_.magnitude(ray, offer.part, offer.t)) return;
    }
    const double scale = geom::max_abs(ray.ray.origin) + at;
    if (at <= 1e-6 * scale || t - at <= 1e-6 * scale) return;
    // A ray that runs within a surface.
    if (may_be_at(p, 4.0 * tolerance(scene_, scale + scene_.size), listed, ray.kind)) return;
    const int blamed = there != outside ? there : listed;
    std::size_t object = 0;
    for (const Part& part : scene_.parts) {
        if (part.solid == blamed) object = std::size_t(part.object);
    }
    statistics_.count_leak({object, "wrong medium", p});
}

/// After a leak: the list at the ray's origin by position alone, and from there anew. The leak
/// stands in the statistics once.
bool EventFinder::recover(TracedRay& ray, double t_max, Event& event) {
    const Statistics counted = statistics_;
    ray.interior = start(ray.ray, ray.kind).interior;
    Contacts surfaces;  // what stands in no list still needs to know its side
    for (const Contact& contact : ray.contacts) {
        if (!scene_.parts[contact.part].is_member) surfaces.push_back(contact);
    }
    ray.contacts = surfaces;
    const bool is_met = find_event(ray, t_max, event);
    statistics_.leaks = counted.leaks;
    statistics_.first_leaks = counted.first_leaks;
    statistics_.leaks_by_object = counted.leaks_by_object;
    return is_met;
}

}  // namespace meniscus::tracer
