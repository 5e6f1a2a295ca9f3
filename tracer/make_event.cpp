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
    event.origin.origin_error += part.shape.to_face(owner.face, event.origin);
    event.solid_before = before.top_solid(scene_);
    event.solid_after = after.top_solid(scene_);
    event.normal = part.shape.normal(owner.face, event.origin);
    if (part.inverse) event.normal = -event.normal;
    event.birth.magnitude = offers_.magnitude(ray, owner.part, t);
    return event;
}

}  // namespace meniscus::tracer
