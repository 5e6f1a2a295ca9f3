#include <algorithm>
#include <cmath>
#include <utility>

#include "tracer/next_event.hpp"

namespace meniscus::tracer {

/// The list of a ray that starts in the open. Where tied solids
/// both hold the origin, the order is that of a ray that comes from infinity along the same line:
/// entered later counts as on top.
TracedRay EventFinder::start(const geom::Ray& ray, RayKind kind) {
    TracedRay result;
    result.ray = ray;
    result.kind = kind;
    result.birth.magnitude = geom::max_abs(ray.origin);
    if (!scene_.has_members || options_.interior == InteriorMode::off) return result;
    if (scene_.is_camera_clear && ray.origin == scene_.source.camera.location) return result;

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
            if (!(t > 0.0)) return false;
            // Farther away, a small distance along the normal means a ray that grazes there.
            if (t > 1e-3 * magnitude) return true;
            return t * std::abs(glm::dot(ray.direction, part.shape.normal(face, ray.at(t)))) >
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

void EventFinder::become(TracedRay& ray, RayKind kind) {
    const RayKind before = std::exchange(ray.kind, kind);
    if (kind == before || scene_.selective.empty()) return;
    const InteriorList fresh = start(ray.ray, kind).interior;
    for (const int index : scene_.selective) {
        const Part& part = scene_.parts[index];
        if (is_visible(part, before) == is_visible(part, kind)) continue;
        while (ray.interior.depth(index) < fresh.depth(index)) ray.interior.enter(index);
        while (ray.interior.depth(index) > fresh.depth(index)) ray.interior.leave(index);
    }
}

}  // namespace meniscus::tracer
