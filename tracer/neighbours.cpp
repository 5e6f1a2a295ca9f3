#include "tracer/neighbours.hpp"

#include <tbb/parallel_for.h>

#include "tracer/render_scene.hpp"

namespace meniscus::tracer {
namespace {

using geom::Bounds;
using geom::Vec3;

/// Of the scene's size and its distance from the origin: far beyond all rounding.
constexpr double margin_share = 1e-5;

/// Whether a ray can cross the surface of an unbounded part within the bounds.
bool may_cross(const Part& part, const Bounds& bounds) {
    const auto* plane = std::get_if<geom::Plane>(&part.shape.shape());
    if (!plane || !part.shape.transform().is_identity()) return true;
    const Vec3 n = plane->normal(0, bounds.low);
    const double reach = glm::dot(glm::abs(n), 0.5 * bounds.size());
    return std::abs(glm::dot(n, bounds.center()) - plane->distance) <= reach;
}

Neighbours::Near find_near(const RenderScene& scene, int index, double margin) {
    Neighbours::Near near;
    const Part& part = scene.parts[std::size_t(index)];
    if (!part.is_member || part.inverse) return near;
    const Bounds bounds = part.shape.bounds().padded(margin);
    near.count = 0;
    const auto add = [&](int other) {
        if (other == index || near.count == Neighbours::unknown) return;
        if (near.count == Neighbours::most) {
            near.count = Neighbours::unknown;
        } else {
            near.parts[std::size_t(near.count++)] = other;
        }
    };
    for (const int other : scene.unbounded) {
        if (may_cross(scene.parts[std::size_t(other)], bounds)) add(other);
    }
    scene.bvh.overlapping(bounds, [&](std::uint32_t box) { add(scene.bvh_parts[box]); });
    return near;
}

}  // namespace

Neighbours find_neighbours(const RenderScene& scene) {
    Neighbours result;
    result.near.resize(scene.parts.size());
    if (!scene.has_members) return result;
    const Bounds& all = scene.bvh.bounds();
    const double farthest = std::max(geom::max_abs(all.low), geom::max_abs(all.high));
    result.margin = margin_share * (scene.size + farthest) + 1000.0 * scene.contact_tolerance;
    tbb::parallel_for(std::size_t{0}, scene.bvh_parts.size(), [&](std::size_t i) {
        const int index = scene.bvh_parts[i];
        result.near[std::size_t(index)] = find_near(scene, index, result.margin);
    });
    return result;
}

}  // namespace meniscus::tracer
