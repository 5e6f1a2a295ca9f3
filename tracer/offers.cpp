#include "tracer/offers.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/ahead.hpp"

namespace meniscus::tracer {
namespace {

const Contact* find(const Contacts& contacts, int part) {
    for (const Contact& contact : contacts) {
        if (contact.part == part) return &contact;
    }
    return nullptr;
}

}  // namespace

double Offers::cosine(const TracedRay& ray, const Part& part, geom::Face face, double t) const {
    return std::abs(glm::dot(ray.ray.direction, part.shape.normal(face, ray.ray.at(t))));
}

double Offers::start_magnitude(const TracedRay& ray, const Part& part) const {
    if (part.anchor != no_anchor && part.anchor == ray.birth.anchor) {
        const SharedAnchor& anchor = scene_.anchors[std::size_t(part.anchor)];
        if (anchor.face == geom::no_face)
            return std::max(ray.birth.anchored_magnitude,
                            geom::max_abs(ray.ray.from(anchor.point))) +
                   anchor.size;
    }
    return rounded_magnitude(ray, part);
}

int Offers::anchor_of(const Offer& offer) const {
    const int index = scene_.parts[offer.part].anchor;
    if (index == no_anchor) return no_anchor;
    const geom::Face face = scene_.anchors[std::size_t(index)].face;
    return face == geom::no_face || face == offer.face ? index : no_anchor;
}

double Offers::magnitude_from(int anchor, const TracedRay& ray, double t) const {
    const SharedAnchor& from = scene_.anchors[std::size_t(anchor)];
    return geom::max_abs(ray.ray.from(from.point)) + t + from.size;
}

double Offers::magnitude(const TracedRay& ray, const Offer& a, const Offer& b) const {
    if (a.part == b.part && scene_.anchors.empty())
        return magnitude(ray, a.part, std::max(a.t, b.t));
    const int anchor = anchor_of(a);
    if (anchor != no_anchor && anchor == anchor_of(b))
        return magnitude_from(anchor, ray, std::max(a.t, b.t));
    return std::max(magnitude(ray, a.part, a.t), magnitude(ray, b.part, b.t));
}

/// The same where only the rounded origin is seen, as `contains` does.
double Offers::rounded_magnitude(const TracedRay& ray, const Part& part) const {
    return std::max(ray.birth.magnitude, geom::max_abs(ray.ray.origin)) + part.shape.magnitude();
}

/// What of a part's shape a ray needs: up to `t_max`, and to the reach of the nearest crossing that
/// ends the segment.
geom::Search Offers::search(const TracedRay& ray, const Part& part, double t_max,
                            Decisive decisive) const {
    geom::Search result;
    result.from = 0.0;
    result.to = t_max;
    result.entering_ends = part.inverse ? decisive.leaving : decisive.entering;
    result.leaving_ends = part.inverse ? decisive.entering : decisive.leaving;
    result.slack = std::max(1e-7 * (geom::max_abs(ray.ray.origin) + part.shape.magnitude()),
                            100.0 * scene_.contact_tolerance);
    result.slack_per_t = 1e-7;
    return result;
}

/// Whether list and position may differ by `distance`, along a normal, where the ray starts.
bool Offers::is_rounding(const TracedRay& ray, const Part& part, double distance) const {
    return distance <= 2.0 * tolerance(scene_, start_magnitude(ray, part));
}

/// Whether the ray starts within rounding of the part's surface: points around its origin are both
/// as deep inside the shape as the one and as the other.
bool Offers::is_at_surface(const TracedRay& ray, const Part& part, int depth, int other) const {
    const double rounding = 2.0 * tolerance(scene_, rounded_magnitude(ray, part));
    bool has_depth = false, has_other = false;
    for (int i = 0; i < 27; ++i) {
        const geom::Vec3 step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        const int there = part.shape.depth_at(ray.ray.origin + rounding * step);
        has_depth = has_depth || there == depth;
        has_other = has_other || there == other;
    }
    return has_depth && has_other;
}

/// Whether the ray starts outside of the part's shape by more than rounding: no point near its
/// origin is inside. The steps are short ones too, for solids that are hardly thicker than the
/// tolerance.
bool Offers::is_far_outside(const TracedRay& ray, const Part& part) const {
    const double rounding = tolerance(scene_, rounded_magnitude(ray, part));
    for (const double widening : {0.5, 1.0, 2.0}) {
        for (int i = 0; i < 27; ++i) {
            const geom::Vec3 step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
            if (part.shape.contains(ray.ray.origin + widening * rounding * step)) return false;
        }
    }
    return true;
}

/// A crossing is forced where list and position disagree by more than rounding; `disagreement` is a
/// distance along the normal, which near an edge may be a neighbour's.
void Offers::count_forced(const TracedRay& ray, const Part& part, double disagreement) {
    if (is_rounding(ray, part, disagreement) || is_at_surface(ray, part, 0, 1)) return;
    statistics_.count_leak({std::size_t(part.object), "forced crossing", ray.ray.origin});
}

void Offers::collect(const TracedRay& ray, int index, double t_max, Decisive decisive,
                     std::vector<Offer>& out) {
    const Part& part = scene_.parts[index];
    const Contact* contact = find(ray.contacts, index);
    if (!part.shape.is_closed()) {
        collect_open(ray, part, index, contact, t_max, decisive, out);
    } else if (part.shape.is_convex()) {
        collect_convex(ray, part, index, contact, t_max, out);
    } else if (!collect_ahead(ray, part, index, contact, t_max, decisive, out)) {
        collect_general(ray, part, index, contact, t_max, out);
    }
}

/// Whether a line's interval, as computed, has the ray's origin in it, up to rounding. A line that
/// misses has none, though it says where a ray that is inside leaves.
bool Offers::holds_origin(const TracedRay& ray, const Part& part,
                          const geom::Interval& interval) const {
    if (!interval.hit) return false;
    const auto is_near = [&](double t, geom::Face face) {
        return is_rounding(ray, part, std::abs(t) * cosine(ray, part, face, t));
    };
    return (interval.t0 <= 0.0 || is_near(interval.t0, interval.face0)) &&
           (interval.t1 >= 0.0 || is_near(interval.t1, interval.face1));
}

void Offers::collect_convex(const TracedRay& ray, const Part& part, int index,
                            const Contact* contact, double t_max, std::vector<Offer>& out) {
    const geom::Interval interval =
        part.shape.interval(ray.ray, contact ? contact->face : geom::no_face);
    // Whether the ray starts inside the shape itself. Opaque solids stand in no list: away from a
    // contact, geometry decides.
    bool inside;
    if (part.is_member) {
        inside = ray.interior.inside(index) != part.inverse;
    } else if (contact) {
        inside = contact->starts_inside != part.inverse;
    } else {
        inside = interval.hit && interval.t0 < 0.0 && interval.t1 > 0.0;
    }

    if (inside) {
        if (!holds_origin(ray, part, interval) && is_far_outside(ray, part))
            statistics_.count_leak({std::size_t(part.object), "forced crossing", ray.ray.origin});
        if (!(interval.t1 <= t_max) || interval.t1 == geom::infinity) return;
        out.push_back({std::max(interval.t1, 0.0), index, interval.face1, part.inverse});
        return;
    }
    if (!interval.hit || !(interval.t1 > 0.0) || interval.t0 > t_max) return;
    const double start = std::max(interval.t0, 0.0);
    const double chord = interval.t1 - start;
    const double magnitude = this->magnitude(ray, {start, index, interval.face0, true},
                                             {interval.t1, index, interval.face1, false});
    // A chord that is thinner than the tolerance is a touch: no crossing, rather than two in one
    // place.
    const double thin = std::max(1e-6 * magnitude, 2.0 * scene_.contact_tolerance);
    if (chord < thin &&
        chord * cosine(ray, part, interval.face1, interval.t1) <= tolerance(scene_, magnitude)) {
        return;
    }
    if (interval.t0 < 0.0) {
        if (contact) return;  // the line runs within the face that the ray starts on
        // The list is right if the ray is about to enter, or if it has left already: whichever is
        // nearer.
        const double behind = interval.t0 == -geom::infinity
                                  ? geom::infinity
                                  : -interval.t0 * cosine(ray, part, interval.face0, interval.t0);
        const double ahead = interval.t1 == geom::infinity
                                 ? geom::infinity
                                 : interval.t1 * cosine(ray, part, interval.face1, interval.t1);
        if (ahead < behind && is_rounding(ray, part, ahead)) return;
        count_forced(ray, part, behind);
    }
    out.push_back({start, index, interval.face0, !part.inverse});
    if (interval.t1 <= t_max && interval.t1 != geom::infinity) {
        out.push_back({interval.t1, index, interval.face1, part.inverse});
    }
}

/// By the short way for meshes, if it is sure (`find_ahead`).
bool Offers::collect_ahead(const TracedRay& ray, const Part& part, int index,
                           const Contact* contact, double t_max, Decisive decisive,
                           std::vector<Offer>& out) {
    const double magnitude = start_magnitude(ray, part);
    KnownStart start{magnitude, tolerance(scene_, magnitude), std::nullopt};
    if (contact) {
        start.born_on = contact->face;
        start.starts_inside = contact->starts_inside != part.inverse;
        start.depth = start.starts_inside ? 1 : 0;
    }
    if (part.is_member) {
        const int listed = ray.interior.depth(index);
        start.depth = part.inverse ? 1 - listed : listed;
        if (*start.depth < 0) return false;
    }
    crossings_.clear();
    const geom::Search search = this->search(ray, part, t_max, decisive);
    if (!find_ahead(part.shape, ray.ray, start, search, crossings_)) return false;
    for (const geom::Crossing& crossing : crossings_)
        out.push_back({crossing.t, index, crossing.face, crossing.entering != part.inverse});
    return true;
}

void Offers::collect_general(const TracedRay& ray, const Part& part, int index,
                             const Contact* contact, double t_max, std::vector<Offer>& out) {
    crossings_.clear();
    part.shape.crossings(ray.ray, crossings_);

    const double magnitude = start_magnitude(ray, part);
    const bool knows_side = part.is_member || contact != nullptr;
    const auto depth_of_ray = [&](int depth_beyond) {
        if (part.is_member) {
            const int listed = ray.interior.depth(index);
            return part.inverse ? 1 - listed : listed;
        }
        if (contact) return contact->starts_inside != part.inverse ? std::max(depth_beyond, 1) : 0;
        return depth_beyond;
    };

    // The zone: crossings at the origin, by their distance along the normal. They are a run of the
    // sorted crossings. Of it, the shortest tail counts that brings the ray's depth to the depth
    // beyond. At an edge or vertex a neighbour's normal may be taken for the distance, so a wider
    // zone is tried before the ray and its place are said to disagree.
    std::size_t zone_begin = 0, zone_end = 0, first = 0;
    int depth_beyond = 0, depth = 0, tail_depth = 0;
    bool zone_is_empty = true;
    for (const double widening : {1.0, 64.0, 4096.0}) {
        const KnownStart start{magnitude, widening * tolerance(scene_, magnitude), std::nullopt};
        const auto in_zone = [&](const geom::Crossing& crossing) {
            return is_at_start(part.shape, ray.ray, start, crossing);
        };
        zone_end = crossings_.size();
        while (zone_end > 0 && crossings_[zone_end - 1].t > 0.0 &&
               !in_zone(crossings_[zone_end - 1]))
            --zone_end;
        zone_begin = zone_end;
        while (zone_begin > 0 && in_zone(crossings_[zone_begin - 1])) --zone_begin;

        if (widening == 1.0) zone_is_empty = zone_begin == zone_end;
        depth_beyond = 0;  // how deep the line is inside just behind the zone
        for (std::size_t i = zone_end; i < crossings_.size(); ++i)
            depth_beyond += crossings_[i].entering ? -1 : 1;
        depth = depth_of_ray(depth_beyond);

        first = zone_end;
        tail_depth = depth_beyond;
        while (tail_depth != depth && first > zone_begin) {
            --first;
            tail_depth += crossings_[first].entering ? -1 : 1;
        }
        if (tail_depth == depth) break;
    }
    if (tail_depth != depth && knows_side) {
        // No tail fits: cross here as often as is missing. That is no leak where the line passes by
        // an edge that the ray starts on.
        const bool passes_by = zone_is_empty && std::abs(depth_beyond - depth) == 1 &&
                               is_at_surface(ray, part, depth, depth_beyond);
        if (part.is_member && !passes_by) {
            statistics_.count_leak({std::size_t(part.object), "forced crossing", ray.ray.origin});
        }
        const geom::Face face = contact                 ? contact->face
                                : zone_end > zone_begin ? crossings_[zone_begin].face
                                : !crossings_.empty()   ? crossings_[0].face
                                                        : 0;
        const bool entering = depth_beyond > depth;
        for (int n = std::abs(depth_beyond - depth); n > 0; --n) {
            out.push_back({0.0, index, face, entering != part.inverse});
        }
        first = zone_end;
    }
    if (!knows_side) first = zone_end;
    for (std::size_t i = first; i < crossings_.size(); ++i) {
        const geom::Crossing& crossing = crossings_[i];
        if (crossing.t > t_max) break;
        out.push_back(
            {std::max(crossing.t, 0.0), index, crossing.face, crossing.entering != part.inverse});
    }
}

void Offers::collect_open(const TracedRay& ray, const Part& part, int index, const Contact* contact,
                          double t_max, Decisive decisive, std::vector<Offer>& out) {
    const double magnitude = start_magnitude(ray, part);
    geom::Search search = this->search(ray, part, t_max, decisive);
    if (contact) search.ends_from = 1e-6 * magnitude;  // see below
    crossings_.clear();
    part.shape.crossings(ray.ray, search, crossings_);
    for (const geom::Crossing& crossing : crossings_) {
        if (!(crossing.t > 0.0)) continue;
        if (crossing.t > t_max) break;
        if (contact) {
            // What a ray was born on it does not meet again.
            if (crossing.face == contact->face) {
                if (crossing.t <= 1e-6 * magnitude) continue;
            }
            if (crossing.t <= 1e-6 * magnitude &&
                crossing.t * cosine(ray, part, crossing.face, crossing.t) <=
                    tolerance(scene_, magnitude)) {
                continue;
            }
        }
        out.push_back({crossing.t, index, crossing.face, crossing.entering});
    }
}

}  // namespace meniscus::tracer
