#include "tracer/next_event.hpp"

namespace meniscus::tracer {
namespace {

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

/// What an event is, but for the lists before and after it and what the rays born there must know.
void EventFinder::make_event(const TracedRay& ray, double t, const Offer& owner, int solid_before,
                             int solid_after, Event& event) const {
    const Part& part = scene_.parts[owner.part];
    event.t = t;
    event.part = owner.part;
    event.skin = owner.part;
    event.face = owner.face;
    event.origin = point_on(ray.ray, t);
    // Put the point back on its face: what rounding and long chords took off it would add up from
    // bounce to bounce.
    const auto [flat, shading] = part.shape.put_on_face(owner.face, event.origin);
    event.normal = part.inverse ? -flat : flat;
    event.shading_normal = shading;
    event.solid_before = solid_before;
    event.solid_after = solid_after;
    event.contacts.clear();
    event.birth = {};
    event.birth.magnitude = offers_.magnitude(ray, owner.part, t);
}

/// Most events are the only crossing far and wide: then the list changes by that alone. False where
/// they are not, or where the solid that is there stays the same.
bool EventFinder::make_lone_event(const TracedRay& ray, int top, Event& event) {
    const Offer& offer = found_.front();
    if (!may_be_true(offer, top)) return false;
    if (found_.size() > 1 &&
        found_[1].t <= reach(scene_, offer.t, offers_.magnitude(ray, offer.part, offer.t)))
        return false;
    const Part& part = scene_.parts[offer.part];
    if (part.is_member && !offer.entering && !part.inverse && !ray.interior.inside(offer.part))
        return false;
    event.before = event.after = ray.interior;
    int top_after = top;
    if (part.is_member) {
        apply(ray, offer, event.after);
        top_after = event.after.top(scene_);
        if (solid_of(top) == solid_of(top_after)) return false;
    }
    make_event(ray, offer.t, offer, solid_of(top), solid_of(top_after), event);
    // Where a higher solid ends inside an opaque one, the opaque one is what is seen.
    if (part.is_member && top_after != outside && scene_.parts[top_after].is_opaque)
        event.skin = top_after;
    event.contacts.push_back({offer.part, offer.face, !offer.entering});
    const int anchor = offers_.anchor_of(offer);
    if (anchor != no_anchor) {
        event.birth.anchor = anchor;
        event.birth.anchored_magnitude = offers_.magnitude_from(anchor, ray, event.t);
    }
    note(offer, true);
    ++statistics_.true_crossings;
    return true;
}

}  // namespace meniscus::tracer
