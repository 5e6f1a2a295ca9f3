#include <algorithm>
#include <cmath>
#include <utility>

#include "tracer/next_event.hpp"

namespace meniscus::tracer {

/// Goes through the sorted offers: false crossings are applied to the list one by one, until a
/// group of coincident ones changes the solid that is there. Then the media before and after the
/// group decide; no order within it is used.
bool EventFinder::walk(TracedRay& ray, Event& event) {
    InteriorList& list = ray.interior;
    used_.assign(found_.size(), 0);
    std::size_t begin = 0;
    while (true) {
        while (begin < found_.size() && used_[begin]) ++begin;
        const std::size_t pivot = find_pivot(list, begin);
        gather_group(ray, begin, pivot);
        for (std::size_t i = begin; i < pivot; ++i) {
            if (used_[i]) continue;
            used_[i] = 1;
            note(found_[i], false);
            apply(ray, found_[i], list);
        }
        if (pivot == found_.size()) return false;

        InteriorList after = list;
        for (const std::uint32_t i : group_) apply(ray, found_[i], after);
        const Offer* surface = surface_in_group();
        const int top_before = list.top(scene_), top_after = after.top(scene_);
        if (surface || solid_of(top_before) != solid_of(top_after)) {
            event.before = list;
            event.after = std::move(after);
            make_group_event(ray, pivot, surface, top_before, top_after, event);
            return true;
        }
        for (const std::uint32_t i : group_) note(found_[i], false);
        list = std::move(after);
    }
}

bool EventFinder::may_be_true(const Offer& offer, int top) const {
    const Part& part = scene_.parts[offer.part];
    if (!part.is_member || top == outside) return true;
    const Part& top_part = scene_.parts[top];
    return offer.entering ? part.priority >= top_part.priority : part.solid == top_part.solid;
}

/// The next crossing that may change what is there; the number of offers if there is none.
std::size_t EventFinder::find_pivot(const InteriorList& list, std::size_t begin) const {
    const int top = list.top(scene_);
    std::size_t pivot = begin;
    while (pivot < found_.size() && (used_[pivot] || !may_be_true(found_[pivot], top))) ++pivot;
    return pivot;
}

/// All that coincides with the pivot: nearer than the tolerance along the steeper of the two
/// normals. What a part does later waits for what it does before: where a ray grazes a face, that
/// may be near and a crossing on the way there far. Sorted by declaration: of entries that tie, the
/// later declared counts as entered last.
void EventFinder::gather_group(const TracedRay& ray, std::size_t begin, std::size_t pivot_index) {
    group_.clear();
    if (pivot_index == found_.size()) return;
    const Offer& pivot = found_[pivot_index];
    const double farthest = reach(scene_, pivot.t, offers_.magnitude(ray, pivot.part, pivot.t));
    double pivot_cosine = -1.0;  // not yet known
    waiting_.clear();
    for (std::size_t i = begin; i < found_.size() && found_[i].t <= farthest; ++i) {
        if (used_[i]) continue;
        const Offer& offer = found_[i];
        const double distance = std::abs(offer.t - pivot.t);
        if (distance > farthest - pivot.t) continue;
        if (distance > 0.0) {
            const double magnitude = offers_.magnitude(ray, pivot, offer);
            if (pivot_cosine < 0.0) pivot_cosine = cosine(ray, pivot);
            if (std::ranges::find(waiting_, offer.part) != waiting_.end()) continue;
            if (distance * std::max(pivot_cosine, cosine(ray, offer)) >
                tolerance(scene_, magnitude)) {
                if (i > pivot_index) waiting_.push_back(offer.part);
                continue;
            }
        }
        group_.push_back(std::uint32_t(i));
        used_[i] = 1;
    }
    std::sort(group_.begin(), group_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return found_[a].part != found_[b].part ? found_[a].part < found_[b].part : a < b;
    });
}

void EventFinder::apply(const TracedRay& ray, const Offer& offer, InteriorList& list) {
    const Part& part = scene_.parts[offer.part];
    if (!part.is_member) return;
    if (offer.entering) {
        list.enter(offer.part);
    } else if (list.inside(offer.part) || part.inverse) {
        list.leave(offer.part);
    } else {
        statistics_.count_leak(
            {std::size_t(part.object), "leaving without entry", ray.ray.at(offer.t)});
    }
}

void EventFinder::note(const Offer& offer, bool is_true) {
    if (record) record->push_back({offer.t, offer.part, offer.entering, is_true});
    if (!is_true) ++statistics_.false_crossings;
}

/// What of the group is met whatever the list says: opaque before merely open, else what the scene
/// has first.
const Offer* EventFinder::surface_in_group() const {
    const Offer* surface = nullptr;
    for (const std::uint32_t i : group_) {
        const Part& part = scene_.parts[found_[i].part];
        if (part.is_member) continue;
        if (!surface || std::pair(!part.is_opaque, found_[i].part) <
                            std::pair(!scene_.parts[surface->part].is_opaque, surface->part))
            surface = &found_[i];
    }
    return surface;
}

/// Whose surface two media share: that of the higher one, which begins or ends here; on a tie, of
/// the solid crossed.
const Offer& EventFinder::owner_of_group(std::size_t pivot, int top_before, int top_after) const {
    const auto crossed = [&](int part, bool entering) -> const Offer* {
        if (part == outside) return nullptr;
        for (const std::uint32_t i : group_) {
            if (found_[i].part == part && found_[i].entering == entering) return &found_[i];
        }
        return nullptr;
    };
    const Offer* begins = crossed(top_after, true);
    const Offer* ends = crossed(top_before, false);
    if (begins && ends && scene_.parts[top_before].priority > scene_.parts[top_after].priority)
        return *ends;
    return begins ? *begins : ends ? *ends : found_[pivot];
}

void EventFinder::make_group_event(const TracedRay& ray, std::size_t pivot, const Offer* surface,
                                   int top_before, int top_after, Event& event) {
    const Offer& owner = surface ? *surface : owner_of_group(pivot, top_before, top_after);
    make_event(ray, found_[pivot].t, owner, solid_of(top_before), solid_of(top_after), event);
    // Where a higher solid ends inside an opaque one, the opaque one is what is seen.
    if (!surface && top_after != outside && scene_.parts[top_after].is_opaque)
        event.skin = top_after;
    for (const std::uint32_t i : group_) {
        const Offer& offer = found_[i];
        note(offer, true);
        const auto crossings_of_part =
            std::count_if(group_.begin(), group_.end(),
                          [&](std::uint32_t other) { return found_[other].part == offer.part; });
        if (crossings_of_part == 1)
            event.contacts.push_back({offer.part, offer.face, !offer.entering});
    }
    const int anchor = offers_.anchor_of(owner);
    if (anchor != no_anchor && std::ranges::all_of(group_, [&](std::uint32_t i) {
            return offers_.anchor_of(found_[i]) == anchor;
        })) {
        event.birth.anchor = anchor;
        event.birth.anchored_magnitude = offers_.magnitude_from(anchor, ray, event.t);
    }
    ++statistics_.true_crossings;
}

}  // namespace meniscus::tracer
