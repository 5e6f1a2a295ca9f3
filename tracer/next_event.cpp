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
                         !options.check_segments) {}

std::optional<Event> EventFinder::next(TracedRay& ray, double t_max) {
    ++statistics_.segments;
    if (has_only_surfaces_ && !record) return next_surface(ray, t_max);
    return options_.interior == InteriorMode::sweep ? sweep(ray, t_max) : recast(ray, t_max);
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
        bound_ = std::min(bound_, reach(scene_, offer.t, offers_.magnitude(ray, index, offer.t)));
        break;  // sorted: what follows lies farther away
    }
}

/// One traversal: everything offered up to the nearest true crossing. The solids of the list and
/// those that the ray starts on are asked first, since rounding could make the ray miss their
/// bounds, and since leaving the top is a first bound.
void EventFinder::collect(const TracedRay& ray, int top, double t_max, Bound by) {
    ++statistics_.casts;
    ++stamp_;
    found_.clear();
    bound_ = t_max;
    if (top != outside) offer(ray, top, top, by);
    for (const InteriorList::Member& member : ray.interior) offer(ray, member.part, top, by);
    for (const Contact& contact : ray.contacts) offer(ray, contact.part, top, by);
    for (const int part : scene_.unbounded) offer(ray, part, top, by);
    scene_.bvh.traverse(ray.ray, bound_, [&](std::uint32_t primitive) {
        offer(ray, scene_.bvh_parts[primitive], top, by);
    });
    std::erase_if(found_, [&](const Offer& offer) { return offer.t > bound_; });
    std::ranges::sort(found_, [](const Offer& a, const Offer& b) {
        return a.t != b.t         ? a.t < b.t
               : a.part != b.part ? a.part < b.part
                                  : a.entering && !b.entering;
    });
}

/// The next event, the ray's list being right. One traversal is enough unless what bounded it was
/// no true crossing after all: a union that overlaps itself is left and still there, a solid is
/// entered and left at one place. Then, and only then, the ray is followed farther.
std::optional<Event> EventFinder::find_event(TracedRay& ray, double t_max) {
    const int top = ray.interior.top(scene_);
    const InteriorList at_start = ray.interior;
    const std::uint64_t false_before = statistics_.false_crossings;
    const std::size_t judged_before = record ? record->size() : 0;
    std::optional<Event> event;
    for (const Bound by : {Bound::true_crossings, Bound::entries, Bound::nothing}) {
        if (by != Bound::true_crossings) {
            statistics_.false_crossings = false_before;
            ray.interior = at_start;
            if (record) record->resize(judged_before);
        }
        collect(ray, top, t_max, by);
        event = walk(ray);
        if (event || bound_ == t_max) break;
    }
    return event;
}

std::optional<Event> EventFinder::sweep(TracedRay& ray, double t_max) {
    const std::uint64_t leaks_before = statistics_.leaks;
    std::optional<Event> event = find_event(ray, t_max);
    if (options_.check_segments) check_segment(ray, event ? event->t : t_max);
    if (!event && t_max == geom::infinity) check_escape(ray);
    return statistics_.leaks == leaks_before ? event : recover(ray, t_max);
}

}  // namespace meniscus::tracer
