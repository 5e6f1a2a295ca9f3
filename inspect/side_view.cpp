#include "inspect/side_view.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/next_event.hpp"

namespace meniscus::inspect {
namespace {

using geom::Vec2;
using geom::Vec3;

/// The opaque solids that stand in no list: what of the row is inside them.
void add_opaque(const tracer::RenderScene& scene, const geom::Ray& row, double length, double y,
                const SideView& view, std::vector<Run>& runs) {
    for (const tracer::Part& part : scene.parts) {
        if (part.is_member || part.inverse || !part.shape.is_closed()) continue;
        geom::Crossings crossings;
        part.shape.crossings(row, crossings);
        double entered = 0.0;
        bool inside = part.shape.contains(row.origin);
        for (const geom::Crossing& crossing : crossings) {
            if (crossing.t <= 0.0) continue;
            const double t = std::min(crossing.t, length);
            if (inside && t > entered)
                runs.push_back({view.low.x + entered, view.low.x + t, y, part.solid, true});
            inside = crossing.entering;
            entered = t;
        }
        if (inside && entered < length)
            runs.push_back({view.low.x + entered, view.high.x, y, part.solid, true});
    }
}

/// The media that the row runs through, from event to event.
void add_media(tracer::EventFinder& finder, const geom::Ray& row, double length, double y,
               const SideView& view, std::vector<Run>& runs) {
    constexpr int max_events = 1000;
    tracer::TracedRay ray = finder.start(row, tracer::RayKind::image);
    double travelled = 0.0;
    for (int i = 0; i < max_events && travelled < length; ++i) {
        const auto event = finder.next(ray, length - travelled);
        const int solid = event ? event->solid_before : ray.interior.top_solid(finder.scene());
        const double end = event ? travelled + event->t : length;
        if (solid != tracer::outside && end > travelled)
            runs.push_back({view.low.x + travelled, view.low.x + end, y, solid, false});
        if (!event) return;
        travelled = end;
        ray.ray = event->origin;
        ray.ray.direction = row.direction;
        ray.interior = event->after;
        ray.contacts = event->contacts;  // as of a ray that stays on this side
        for (tracer::Contact& contact : ray.contacts) {
            contact.starts_inside = !contact.starts_inside;
        }
        ray.birth = event->birth;
    }
}

/// The axis that the picture's upper edge is nearest to, so that floors are level; else the
/// camera's own up.
Vec3 upright(const scene::Camera& camera, const Vec3& direction) {
    const Vec3 up = glm::normalize(camera.up);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(up[axis]) < 0.7 || std::abs(direction[axis]) > 0.99) continue;
        Vec3 result{0.0};
        result[axis] = up[axis] > 0.0 ? 1.0 : -1.0;
        return result;
    }
    return up;
}

}  // namespace

SideView::SideView(const scene::Camera& camera, const PixelTrace& trace) {
    const geom::Ray& ray = trace.segments.at(0).node.start.ray;
    origin = ray.origin;
    upwards = upright(camera, ray.direction);
    across = ray.direction - glm::dot(ray.direction, upwards) * upwards;
    if (glm::length(across) < 1e-6) across = camera.right;
    across = glm::normalize(across - glm::dot(across, upwards) * upwards);

    bool empty = true;
    const auto extend = [&](const Vec2& q) {
        low = empty ? q : glm::min(low, q);
        high = empty ? q : glm::max(high, q);
        empty = false;
    };
    constexpr double least_weight = 0.05;  // what is fainter does not shape the picture
    for (const Segment& segment : trace.segments) {
        if (segment.ends_at_surface() && segment.node.weight >= least_weight)
            extend(project(segment.node.event.origin.at(0.0)));
    }
    if (empty) extend(Vec2{0.0});
    // A margin for what comes and goes; never a window without height.
    double side = std::max(high.x - low.x, high.y - low.y);
    if (side <= 0.0) side = std::max(1.0, 0.5 * geom::max_abs(point(low) - origin));
    const Vec2 middle = 0.5 * (low + high);
    const Vec2 half{0.5 * (high.x - low.x) + 0.35 * side,
                    std::max(0.5 * (high.y - low.y) + 0.2 * side, 0.45 * side)};
    low = middle - half;
    high = middle + half;
}

std::vector<Run> cross_section(const tracer::RenderScene& scene, const SideView& view, int rows) {
    tracer::Statistics statistics;
    const tracer::Options options;
    tracer::EventFinder finder(scene, options, statistics);
    std::vector<Run> runs;
    for (int i = 0; i < rows; ++i) {
        const double y = view.low.y + view.size().y * (i + 0.5) / rows;
        geom::Ray row;
        row.origin = view.point({view.low.x, y});
        row.direction = view.across;
        add_opaque(scene, row, view.size().x, y, view, runs);
        add_media(finder, row, view.size().x, y, view, runs);
    }
    return runs;
}

}  // namespace meniscus::inspect
