#pragma once

#include "geom/bounds.hpp"
#include "inspect/pixel_trace.hpp"

namespace meniscus::inspect {

/// The plane of a camera ray and of `up`, as a drawing: across grows to the right, upwards to the
/// top. What lies off the plane is seen as its shadow on it.
struct SideView {
    geom::Vec3 origin{0.0}, across{1.0, 0.0, 0.0}, upwards{0.0, 1.0, 0.0};
    geom::Vec2 low{0.0}, high{1.0};  // the window, in scene units from `origin`

    /// The plane of the first segment, and a window that holds all places where the tree meets
    /// something and some way before and behind.
    SideView(const scene::Camera& camera, const PixelTrace& trace);

    geom::Vec2 project(const geom::Vec3& p) const {
        return {glm::dot(p - origin, across), glm::dot(p - origin, upwards)};
    }
    geom::Vec3 point(const geom::Vec2& q) const { return origin + q.x * across + q.y * upwards; }
    geom::Vec2 size() const { return high - low; }
};

/// What of the plane a solid fills: from `x0` to `x1` at height `y`, all in the view's units.
struct Run {
    double x0, x1, y;
    int solid;
    bool is_opaque;
};

/// The cross-section, in rows: what a ray that goes across meets, by the tracer's own word.
std::vector<Run> cross_section(const tracer::RenderScene& scene, const SideView& view, int rows);

}  // namespace meniscus::inspect
