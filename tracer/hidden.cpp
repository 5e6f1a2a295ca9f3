#include "tracer/hidden.hpp"

#include <algorithm>
#include <vector>

#include "tracer/containment.hpp"

namespace meniscus::tracer {
namespace {

/// Whether a part is there for all rays.
bool is_for_all(const Part& part) {
    return !part.no_image && !part.no_reflection && !part.no_shadow;
}

bool may_hide(const Part& outer, const Part& inner) {
    return outer.is_member && !outer.inverse && is_for_all(outer) &&
           outer.priority > inner.priority;
}

/// So many triangles of meshes in meshes are looked at, in a second or so; further ones stay.
constexpr std::size_t most_triangles = 4'000'000;

/// How many triangles it takes to tell whether one part holds another.
std::size_t triangles(const Part& outer, const Part& inner) {
    const auto* around = std::get_if<geom::Mesh>(&outer.shape.shape());
    const auto* within = std::get_if<geom::Mesh>(&inner.shape.shape());
    return around && within ? around->triangles->size() + within->triangles->size() : 0;
}

}  // namespace

std::size_t leave_out_hidden(RenderScene& scene) {
    double highest = -geom::infinity;
    for (const Part& part : scene.parts) {
        if (part.is_member) highest = std::max(highest, part.priority);
    }
    const double room = room_to_spare(scene);
    std::size_t triangles_left = most_triangles;
    std::vector<bool> is_hidden;
    for (const Part& part : scene.parts) {
        bool hidden = false;
        const auto look = [&](int index) {
            const Part& outer = scene.parts[std::size_t(index)];
            if (hidden || !may_hide(outer, part)) return;
            const std::size_t count = triangles(outer, part);
            if (count > triangles_left) return;
            triangles_left -= count;
            hidden = is_contained(part.shape, outer.shape, room).value_or(false);
        };
        if (part.is_member && !part.inverse && part.priority < highest &&
            part.shape.bounds().is_finite()) {
            for (const int index : scene.unbounded) look(index);
            scene.bvh.holding(part.shape.bounds(),
                              [&](std::uint32_t box) { look(scene.bvh_parts[box]); });
        }
        is_hidden.push_back(hidden);
    }
    std::size_t place = 0;
    return std::erase_if(scene.parts, [&](const Part&) { return is_hidden[place++]; });
}

}  // namespace meniscus::tracer
