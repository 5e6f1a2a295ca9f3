#include "tracer/next_event.hpp"

#include <algorithm>
#include <cmath>

namespace meniscus::tracer {
namespace {

/// Crossings this much farther than the nearest true one may still coincide with it along the
/// normal, at grazing angles.
double reach(const RenderScene& scene, double t, double magnitude) {
    return t + std::max(1e-7 * magnitude, 100.0 * scene.contact_tolerance);
}

/// The exact rounding error of a + b (Knuth's two-sum), where `sum` is the rounded sum.
double sum_error(double a, double b, double sum) {
    const double b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part);
}

/// o + t d as an origin for new rays: the rounded point and what rounding took from it.
geom::Ray point_on(const geom::Ray& ray, double t) {
    geom::Ray point;
    const geom::Vec3 way = ray.origin_error + t * ray.direction;
    point.origin = ray.origin + way;
    for (int i = 0; i < 3; ++i)
        point.origin_error[i] = sum_error(ray.origin[i], way[i], point.origin[i]);
    return point;
}

}  // namespace

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
    if (options_.check_segments) check_midpoint(ray, event ? event->t : geom::infinity);
    if (!event && t_max == geom::infinity) check_escape(ray);
    return event;
}

/// Goes through the sorted offers: false crossings are applied to the list one by one, until a
/// group of coincident ones changes the solid that is there. Then the media before and after the
/// group decide; no order within it is used.
std::optional<Event> EventFinder::walk(TracedRay& ray) {
    InteriorList& list = ray.interior;
    used_.assign(found_.size(), 0);

    const auto apply = [&](InteriorList& to, const Offer& offer) {
        const Part& part = scene_.parts[offer.part];
        if (!part.is_member) return;
        if (offer.entering) {
            to.enter(offer.part);
        } else if (to.inside(offer.part) || part.inverse) {
            to.leave(offer.part);
        } else {
            statistics_.count_leak(
                {std::size_t(part.object), "leaving without entry", ray.ray.at(offer.t)});
        }
    };
    const auto note = [&](const Offer& offer, bool is_true) {
        if (record) record->push_back({offer.t, offer.part, offer.entering, is_true});
        if (!is_true) ++statistics_.false_crossings;
    };

    geom::InlineVector<std::uint32_t, 16> group;
    std::size_t begin = 0;
    while (true) {
        while (begin < found_.size() && used_[begin]) ++begin;
        // The next crossing that may change what is there.
        const int top = list.top(scene_);
        const Part* top_part = top == outside ? nullptr : &scene_.parts[top];
        std::size_t key = begin;
        for (; key < found_.size(); ++key) {
            if (used_[key]) continue;
            const Part& part = scene_.parts[found_[key].part];
            if (!part.is_member || !top_part) break;
            if (found_[key].entering ? part.priority >= top_part->priority
                                     : part.solid == top_part->solid)
                break;
        }
        if (key == found_.size()) break;

        // All that coincides with it: nearer than the tolerance along the steeper of the two
        // normals.
        const Offer& pivot = found_[key];
        const double t = pivot.t;
        const double pivot_magnitude = offers_.magnitude(ray, pivot.part, t);
        const double farthest = reach(scene_, t, pivot_magnitude);
        group.clear();
        double pivot_cosine = -1.0;
        for (std::size_t i = begin; i < found_.size() && found_[i].t <= farthest; ++i) {
            if (used_[i]) continue;
            const Offer& offer = found_[i];
            const double distance = std::abs(offer.t - t);
            if (distance > farthest - t) continue;
            if (distance > 0.0) {
                const double magnitude =
                    std::max(pivot_magnitude, offers_.magnitude(ray, offer.part, offer.t));
                if (pivot_cosine < 0.0) pivot_cosine = cosine(ray, pivot);
                if (distance * std::max(pivot_cosine, cosine(ray, offer)) >
                    tolerance(scene_, magnitude))
                    continue;
            }
            group.push_back(std::uint32_t(i));
        }
        for (const std::uint32_t i : group) used_[i] = 2;
        for (std::size_t i = begin; i < key; ++i) {
            if (used_[i]) continue;
            used_[i] = 1;
            note(found_[i], false);
            apply(list, found_[i]);
        }

        // Entries of one group tie by declaration: the later declared counts as entered last.
        std::sort(group.begin(), group.end(), [&](std::uint32_t a, std::uint32_t b) {
            return found_[a].part != found_[b].part ? found_[a].part < found_[b].part : a < b;
        });
        InteriorList after = list;
        const Offer* surface = nullptr;
        for (const std::uint32_t i : group) {
            const Offer& offer = found_[i];
            apply(after, offer);
            if (!scene_.parts[offer.part].is_member &&
                (!surface ||
                 scene_.parts[offer.part].is_opaque > scene_.parts[surface->part].is_opaque)) {
                surface = &offer;
            }
        }
        const int solid_before = list.top_solid(scene_), solid_after = after.top_solid(scene_);
        if (!surface && solid_before == solid_after) {
            for (const std::uint32_t i : group) note(found_[i], false);
            list = after;
            continue;
        }

        // Whose surface it is: the higher of the two media's, which begins or ends here; on a tie,
        // the solid crossed.
        const Offer* owner = surface;
        int skin = surface ? surface->part : outside;
        if (!owner) {
            const int top_before = list.top(scene_), top_after = after.top(scene_);
            const auto crossed = [&](int top_of, bool entering) -> const Offer* {
                if (top_of == outside) return nullptr;
                for (const std::uint32_t i : group) {
                    if (found_[i].part == top_of && found_[i].entering == entering)
                        return &found_[i];
                }
                return nullptr;
            };
            const Offer* begins = crossed(top_after, true);
            const Offer* ends = crossed(top_before, false);
            owner = begins ? begins : ends;
            if (begins && ends &&
                scene_.parts[top_before].priority > scene_.parts[top_after].priority)
                owner = ends;
            if (!owner) owner = &pivot;
            skin = owner->part;
            // Where a higher solid ends inside an opaque one, the opaque one is what is seen.
            if (top_after != outside && scene_.parts[top_after].is_opaque) skin = top_after;
        }
        Event event = make_event(ray, t, *owner, list, after);
        event.skin = skin;
        event.solid_before = solid_before;
        event.solid_after = solid_after;
        for (const std::uint32_t i : group) {
            const Offer& offer = found_[i];
            note(offer, true);
            const auto crossings_of_part = std::count_if(
                group.begin(), group.end(),
                [&](std::uint32_t other) { return found_[other].part == offer.part; });
            if (crossings_of_part == 1)
                event.contacts.push_back({offer.part, offer.face, !offer.entering});
        }
        ++statistics_.true_crossings;
        return event;
    }

    for (std::size_t i = begin; i < found_.size(); ++i) {
        if (used_[i]) continue;
        note(found_[i], false);
        apply(list, found_[i]);
    }
    return std::nullopt;
}

Event EventFinder::make_event(const TracedRay& ray, double t, const Offer& owner,
                              const InteriorList& before, const InteriorList& after) const {
    const Part& part = scene_.parts[owner.part];
    Event event;
    event.t = t;
    event.part = owner.part;
    event.skin = owner.part;
    event.face = owner.face;
    event.before = before;
    event.after = after;
    event.origin = point_on(ray.ray, t);
    // Put the point back on its face: what rounding and long chords took off it would add up from
    // bounce to bounce.
    const geom::Vec3 p = event.origin.origin;
    event.origin.origin_error += part.shape.on_face(owner.face, p + event.origin.origin_error) -
                                 (p + event.origin.origin_error);
    event.normal = part.shape.normal(owner.face, p);
    if (part.inverse) event.normal = -event.normal;
    event.magnitude = offers_.magnitude(ray, owner.part, t);
    return event;
}

/// The list of a ray that starts in the open. Where tied solids
/// both hold the origin, the order is that of a ray that comes from infinity along the same line:
/// entered later counts as on top.
TracedRay EventFinder::start(const geom::Ray& ray, RayKind kind) {
    TracedRay result;
    result.ray = ray;
    result.kind = kind;
    result.birth_magnitude = geom::max_abs(ray.origin);
    if (!scene_.has_members || options_.interior == InteriorMode::off) return result;

    struct Start {
        double entered_at;
        int part;
        int depth;
    };
    std::vector<Start> starts;
    const auto ask = [&](int index) {
        const Part& part = scene_.parts[index];
        if (!part.is_member || !is_visible(part, kind)) return;
        // Asked along the ray, so that an origin on a surface is where the ray goes.
        const double magnitude = geom::max_abs(ray.origin) + part.shape.magnitude();
        const auto is_ahead = [&](double t, geom::Face face) {
            return t > 0.0 &&
                   t * std::abs(glm::dot(ray.direction, part.shape.normal(face, ray.at(t)))) >
                       tolerance(scene_, magnitude);
        };
        int shape_depth = 0;
        double entered_at = -geom::infinity;
        if (part.shape.is_convex()) {
            const geom::Interval interval = part.shape.interval(ray, geom::no_face);
            if (!interval.hit) {
                shape_depth = 0;
            } else if (is_ahead(interval.t1, interval.face1) || interval.t1 == geom::infinity) {
                shape_depth =
                    interval.t0 == geom::infinity || is_ahead(interval.t0, interval.face0) ? 0 : 1;
            }
            if (part.inverse) {
                if (interval.hit && !(interval.t1 > 0.0)) entered_at = interval.t1;
            } else {
                entered_at = interval.t0;
            }
        } else {
            geom::Crossings crossings;
            part.shape.crossings(ray, crossings);
            for (const geom::Crossing& crossing : crossings) {
                if (is_ahead(crossing.t, crossing.face)) {
                    shape_depth += crossing.entering ? -1 : 1;
                } else if (crossing.entering != part.inverse) {
                    entered_at = crossing.t;
                }
            }
        }
        const int depth = part.inverse ? 1 - shape_depth : shape_depth;
        if (depth == 0) return;
        starts.push_back({entered_at, index, depth});
    };
    for (const int part : scene_.unbounded) ask(part);
    // Boxes are asked with a margin, since an origin on a surface may lie a rounding outside of
    // them.
    const double margin = tolerance(scene_, 4.0 * (geom::max_abs(ray.origin) + scene_.size));
    scene_.bvh.overlapping(geom::Bounds{ray.origin, ray.origin}.padded(margin),
                           [&](std::uint32_t primitive) { ask(scene_.bvh_parts[primitive]); });
    std::ranges::sort(starts, [](const Start& a, const Start& b) {
        return a.entered_at != b.entered_at ? a.entered_at < b.entered_at : a.part < b.part;
    });
    for (const Start& start : starts) {
        for (int n = 0; n < start.depth; ++n) result.interior.enter(start.part);
        for (int n = start.depth; n < 0; ++n) result.interior.leave(start.part);
    }
    return result;
}

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
