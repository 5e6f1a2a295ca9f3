#include <algorithm>

#include "tracer/next_event.hpp"

namespace meniscus::tracer {
namespace {

/// The nearest crossing so far, and how far away the next one is.
struct Nearest {
    double t = geom::infinity, second = geom::infinity;
    int part = outside;
    geom::Face face = geom::no_face;
    bool entering = false;

    bool offer(double at, int of, geom::Face on, bool enters) {
        if (at >= t) {
            second = std::min(second, at);
            return false;
        }
        *this = {at, t, of, on, enters};
        return true;
    }
};

}  // namespace

/// The next event where no solid can hold a ray, or none that the ray cares for, so that there are
/// no lists and every crossing is true: the nearest one. Where another coincides with it or a chord
/// is as thin as rounding, the way with lists decides.
bool EventFinder::next_surface(TracedRay& ray, double t_max, Event& event) {
    ++statistics_.casts;
    ++stamp_;
    bound_ = t_max;
    Nearest nearest;
    bool is_thin = false;
    const auto see = [&](int index, const Contact* contact) {
        if (visited_[index] == stamp_) return;
        visited_[index] = stamp_;
        const Part& part = scene_.parts[index];
        if (!is_visible(part, ray.kind)) return;
        if (ray.kind == RayKind::shadow && only_opaque_shades_ && !part.is_opaque) return;
        const auto take = [&](double t, geom::Face face, bool entering) {
            if (!(t <= bound_) || t == geom::infinity) return;
            if (nearest.offer(t, index, face, entering))
                bound_ = std::min(bound_, reach(scene_, t, offers_.magnitude(ray, index, t)));
        };
        if (!part.shape.is_closed() || !part.shape.is_convex()) {
            found_.clear();
            offers_.collect(ray, index, bound_, {true, true}, found_);
            for (const Offer& offer : found_) take(offer.t, offer.face, offer.entering);
            return;
        }
        const geom::Interval interval =
            part.shape.interval(ray.ray, contact ? contact->face : geom::no_face);
        const bool inside = contact ? contact->starts_inside != part.inverse
                                    : interval.hit && interval.t0 < 0.0 && interval.t1 > 0.0;
        if (inside) return take(std::max(interval.t1, 0.0), interval.face1, part.inverse);
        if (!interval.hit || !(interval.t1 > 0.0) || interval.t0 > bound_) return;
        const double start = std::max(interval.t0, 0.0);
        if (interval.t1 - start < std::max(1e-6 * offers_.magnitude(ray, index, interval.t1),
                                           2.0 * scene_.contact_tolerance))
            is_thin = true;
        if (interval.t0 < 0.0) return;  // the line runs within the face that the ray starts on
        take(start, interval.face0, !part.inverse);
    };
    for (const Contact& contact : ray.contacts) see(contact.part, &contact);
    for (const int part : scene_.unbounded) see(part, nullptr);
    scene_.bvh.traverse(ray.ray, bound_, [&](std::uint32_t primitive) {
        see(scene_.bvh_parts[primitive], nullptr);
    });
    if (is_thin || nearest.second <= bound_) {
        --statistics_.casts;
        return sweep(ray, t_max, event);
    }
    if (nearest.part == outside) return false;
    event.before = event.after = ray.interior;
    make_event(ray, nearest.t, {nearest.t, nearest.part, nearest.face, nearest.entering}, outside,
               outside, event);
    event.contacts.push_back({nearest.part, nearest.face, !nearest.entering});
    ++statistics_.true_crossings;
    return true;
}

}  // namespace meniscus::tracer
