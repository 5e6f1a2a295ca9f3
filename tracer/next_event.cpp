#include "tracer/next_event.hpp"

#include <algorithm>
#include <cmath>

namespace meniscus::tracer {

EventFinder::EventFinder(const RenderScene& scene, const Options& options, Statistics& statistics)
    : scene_(scene),
      options_(options),
      statistics_(statistics),
      offers_(scene, statistics),
      visited_(scene.parts.size(), 0) {}

std::optional<Event> EventFinder::next(TracedRay& ray, double t_max) {
    ++statistics_.segments;
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
/// is true.
void EventFinder::offer(const TracedRay& ray, int index, int top, bool bound_by_exits) {
    if (visited_[index] == stamp_) return;
    visited_[index] = stamp_;
    const Part& part = scene_.parts[index];
    if (!is_visible(part, ray.kind)) return;

    const std::size_t first = found_.size();
    offers_.collect(ray, index, bound_, found_);
    for (std::size_t i = first; i < found_.size(); ++i) {
        const Offer& offer = found_[i];
        bool is_true = !part.is_member, is_sure = true;
        if (part.is_member && top == outside) {
            is_true = offer.entering;
        } else if (part.is_member) {
            const Part& top_part = scene_.parts[top];
            if (offer.entering) {
                is_true = part.priority >= top_part.priority && part.solid != top_part.solid;
            } else if (bound_by_exits && index == top) {
                // Leaving the top is true unless another part of the same solid, or the same part
                // again, is still there.
                is_true = true;
                is_sure = false;
            }
        }
        if (!is_true) continue;
        const double limit = reach(scene_, offer.t, offers_.magnitude(ray, index, offer.t));
        if (limit < bound_) {
            bound_ = limit;
            bound_is_sure_ = is_sure;
        }
        break;  // sorted: what follows lies farther away
    }
}

/// One traversal: everything offered up to the nearest true crossing. The solids of the list and
/// those that the ray starts on are asked first, since rounding could make the ray miss their
/// bounds, and since leaving the top is a first bound.
void EventFinder::collect(const TracedRay& ray, int top, double t_max, bool bound_by_exits) {
    ++statistics_.casts;
    ++stamp_;
    found_.clear();
    bound_ = t_max;
    bound_is_sure_ = true;
    if (top != outside) offer(ray, top, top, bound_by_exits);
    for (const InteriorList::Member& member : ray.interior)
        offer(ray, member.part, top, bound_by_exits);
    for (const Contact& contact : ray.contacts) offer(ray, contact.part, top, bound_by_exits);
    for (const int part : scene_.unbounded) offer(ray, part, top, bound_by_exits);
    scene_.bvh.traverse(ray.ray, bound_, [&](std::uint32_t primitive) {
        offer(ray, scene_.bvh_parts[primitive], top, bound_by_exits);
    });
    std::erase_if(found_, [&](const Offer& offer) { return offer.t > bound_; });
    std::ranges::sort(found_, [](const Offer& a, const Offer& b) {
        return a.t != b.t         ? a.t < b.t
               : a.part != b.part ? a.part < b.part
                                  : !a.entering && b.entering;
    });
}

std::optional<Event> EventFinder::sweep(TracedRay& ray, double t_max) {
    const int top = ray.interior.top(scene_);
    const std::uint64_t leaks_before = statistics_.leaks;
    collect(ray, top, t_max, true);
    const bool was_sure = bound_is_sure_;
    const std::uint64_t false_before = statistics_.false_crossings;
    InteriorList at_start;
    if (!was_sure) at_start = ray.interior;
    std::optional<Event> event = walk(ray);
    if (!event && !was_sure) {
        // What bounded the traversal was no true crossing after all (a union that overlaps itself):
        // look farther.
        statistics_.false_crossings = false_before;
        ray.interior = at_start;
        collect(ray, top, t_max, false);
        event = walk(ray);
    }
    if (options_.check_segments) check_segment(ray, event ? event->t : t_max);
    if (!event && t_max == geom::infinity) check_escape(ray);
    return statistics_.leaks == leaks_before ? event : recover(ray, t_max);
}

}  // namespace meniscus::tracer
