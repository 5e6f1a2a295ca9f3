#include "tracer/next_event.hpp"

#include <algorithm>
#include <cmath>

namespace meniscus::tracer {

EventFinder::EventFinder(const RenderScene& scene, const Options& options, Statistics& statistics)
    : scene_(scene),
      options_(options),
      statistics_(statistics),
      offers_(scene, statistics),
      visited_(scene.parts.size(), 0),
      has_only_surfaces_(!scene.has_members && options.interior == InteriorMode::sweep &&
                         !options.check_segments),
      only_opaque_shades_(scene.only_opaque_shades && options.interior == InteriorMode::sweep &&
                          !options.check_segments) {}

bool EventFinder::next(TracedRay& ray, double t_max, Event& event) {
    ++statistics_.segments;
    const bool needs_no_list =
        has_only_surfaces_ || (only_opaque_shades_ && ray.kind == RayKind::shadow);
    if (needs_no_list && !record) return next_surface(ray, t_max, event);
    return options_.interior == InteriorMode::sweep ? sweep(ray, t_max, event)
                                                    : recast(ray, t_max, event);
}

bool EventFinder::is_visible(const Part& part, RayKind kind) const {
    switch (kind) {
        case RayKind::image:
            return !part.no_image;
        case RayKind::reflection:
            return !part.no_reflection;
        case RayKind::shadow:
            return !part.no_shadow || part.is_member;
    }
    return true;
}

double EventFinder::cosine(const TracedRay& ray, const Offer& offer) const {
    return std::abs(glm::dot(
        ray.ray.direction, scene_.parts[offer.part].shape.normal(offer.face, ray.ray.at(offer.t))));
}

/// Takes what `part` offers up to the bound, and draws the bound nearer where one of its crossings
/// may be true.
void EventFinder::offer(const TracedRay& ray, int index, int top, Bound by) {
    if (visited_[index] == stamp_) return;
    visited_[index] = stamp_;
    const Part& part = scene_.parts[index];
    if (!is_visible(part, ray.kind)) return;

    Decisive decisive{by != Bound::nothing, by != Bound::nothing};
    if (by != Bound::nothing && part.is_member && top == outside) {
        decisive.leaving = false;
    } else if (by != Bound::nothing && part.is_member) {
        const Part& top_part = scene_.parts[top];
        decisive.entering = part.priority >= top_part.priority && part.solid != top_part.solid;
        decisive.leaving = by == Bound::true_crossings && index == top;
    }

    const std::size_t first = found_.size();
    offers_.collect(ray, index, bound_, decisive, found_);
    for (std::size_t i = first; i < found_.size(); ++i) {
        const Offer& offer = found_[i];
        if (!(offer.entering ? decisive.entering : decisive.leaving)) continue;
        const double end = reach(scene_, offer.t, offers_.magnitude(ray, index, offer.t));
        if (end < bound_) {
            bound_ = end;
            bounding_t_ = offer.t;
        }
        break;  // sorted: what follows lies farther away
    }
}

/// Whether the ray leaves its top, and so ends, before it comes to anything that is not inside of
/// that one: what holds it is farther off, as the list says that it does hold it, and nothing else
/// is near.
bool EventFinder::is_shut_in(const TracedRay& ray, int top) const {
    const Nesting& nesting = scene_.nesting;
    if (nesting.is_empty() || top == outside || !nesting.places[top].is_alone) return false;
    if (!scene_.parts[top].shape.is_convex()) return false;
    if (bound_ == geom::infinity || bound_ - bounding_t_ >= nesting.margin) return false;
    std::uint32_t holders = 0;
    for (const InteriorList::Member& member : ray.interior)
        holders += member.depth > 0 && nesting.holds(member.part, top);
    return holders == nesting.places[top].level;
}

/// All that the ray may meet before it leaves its top, and so ends: what is near that solid. Null
/// if it is not known, or if the ray may go on.
const Neighbours::Near* EventFinder::neighbours_of(int top) const {
    if (top == outside || bound_ == geom::infinity) return nullptr;
    const Neighbours::Near& near = scene_.neighbours.near[std::size_t(top)];
    const bool is_known =
        near.count != Neighbours::unknown && bound_ - bounding_t_ < scene_.neighbours.margin;
    return is_known ? &near : nullptr;
}

/// Asks parts that the same solid holds, and what is inside of them in turn, unless the ray ends
/// before it is there.
void EventFinder::ask_group(const TracedRay& ray, int index, int top, Bound by) {
    if (index < 0) return;
    const Nesting& nesting = scene_.nesting;
    const Nesting::Group& group = nesting.groups[index];
    const auto ask = [&](std::uint32_t i) {
        const int part = group.parts[i];
        const bool is_new = visited_[part] != stamp_;
        const std::size_t first = found_.size();
        offer(ray, part, top, by);
        const int held = nesting.places[part].held;
        if (held < 0) return;
        if (is_new && !ray.interior.inside(part)) {
            if (found_.size() == first) return;  // missed, or too far away
            const Offer& offer = found_[first];
            if (offer.entering && bound_ < offer.t + nesting.margin) return;
        }
        ask_group(ray, held, top, by);
    };
    if (group.bvh.empty()) {
        for (std::uint32_t i = 0; i < group.parts.size(); ++i) ask(i);
    } else {
        group.bvh.traverse(ray.ray, bound_, ask);
    }
}

/// Whether a sphere, of those that the ray is not known to be at, has nothing to offer: its
/// interval is the one that `offer` would find.
bool EventFinder::misses_sphere(const TracedRay& ray, std::uint32_t primitive) const {
    if (scene_.bvh_spheres.empty()) return false;
    const geom::Sphere& sphere = scene_.bvh_spheres[primitive];
    if (sphere.radius == 0.0) return false;
    const geom::Interval interval = sphere.interval(ray.ray, geom::no_face);
    return !interval.hit || !(interval.t1 > 0.0) || interval.t0 > bound_;
}

/// One traversal: everything offered up to the nearest true crossing. The solids of the list and
/// those that the ray starts on are asked first, since rounding could make the ray miss their
/// bounds, and since leaving the top is a first bound.
void EventFinder::collect(const TracedRay& ray, int top, double t_max, Bound by) {
    ++statistics_.casts;
    ++stamp_;
    found_.clear();
    bound_ = bounding_t_ = t_max;
    if (top != outside) offer(ray, top, top, by);
    const Nesting& nesting = scene_.nesting;
    const bool shut_in = by == Bound::true_crossings && is_shut_in(ray, top);
    const Neighbours::Near* const near = by == Bound::true_crossings ? neighbours_of(top) : nullptr;
    for (const InteriorList::Member& member : ray.interior) {
        if (!shut_in || !nesting.holds(member.part, top)) offer(ray, member.part, top, by);
    }
    for (const Contact& contact : ray.contacts) offer(ray, contact.part, top, by);
    if (near) {
        for (int i = 0; i < near->count; ++i) offer(ray, near->parts[std::size_t(i)], top, by);
        return sort_found();
    }
    for (const int part : scene_.unbounded) offer(ray, part, top, by);
    if (!nesting.is_empty()) {
        ask_group(ray, shut_in ? nesting.places[top].held : 0, top, by);
    } else if (scene_.has_few_parts) {
        for (const int part : scene_.bvh_parts) offer(ray, part, top, by);
    } else {
        scene_.bvh.traverse(ray.ray, bound_, [&](std::uint32_t primitive) {
            if (!misses_sphere(ray, primitive)) offer(ray, scene_.bvh_parts[primitive], top, by);
        });
    }
    sort_found();
}

/// What lies within the bound, as the ray comes to it.
void EventFinder::sort_found() {
    std::erase_if(found_, [&](const Offer& offer) { return offer.t > bound_; });
    if (found_.size() < 2) return;
    std::ranges::sort(found_, [](const Offer& a, const Offer& b) {
        return a.t != b.t         ? a.t < b.t
               : a.part != b.part ? a.part < b.part
                                  : a.entering && !b.entering;
    });
}

/// The next event, the ray's list being right. One traversal is enough unless what bounded it was
/// no true crossing after all: a union that overlaps itself is left and still there, a solid is
/// entered and left at one place. Then, and only then, the ray is followed farther.
bool EventFinder::find_event(TracedRay& ray, double t_max, Event& event) {
    const int top = ray.interior.top(scene_);
    collect(ray, top, t_max, Bound::true_crossings);
    if (found_.empty()) return false;
    if (make_lone_event(ray, top, event)) return true;

    const InteriorList at_start = ray.interior;
    const std::uint64_t false_before = statistics_.false_crossings;
    const std::size_t judged_before = record ? record->size() : 0;
    if (walk(ray, event)) return true;
    for (const Bound by : {Bound::entries, Bound::nothing}) {
        if (bound_ == t_max) return false;
        statistics_.false_crossings = false_before;
        ray.interior = at_start;
        if (record) record->resize(judged_before);
        collect(ray, top, t_max, by);
        if (walk(ray, event)) return true;
    }
    return false;
}

bool EventFinder::sweep(TracedRay& ray, double t_max, Event& event) {
    const std::uint64_t leaks_before = statistics_.leaks;
    const bool is_met = find_event(ray, t_max, event);
    if (options_.check_segments) check_segment(ray, is_met ? event.t : t_max);
    if (!is_met && t_max == geom::infinity) check_escape(ray);
    return statistics_.leaks == leaks_before ? is_met : recover(ray, t_max, event);
}

}  // namespace meniscus::tracer
