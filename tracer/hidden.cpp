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

bool hides(const Part& outer, const Part& inner, double room) {
    return outer.is_member && !outer.inverse && is_for_all(outer) &&
           outer.priority > inner.priority &&
           is_contained(inner.shape, outer.shape, room).value_or(false);
}

}  // namespace

std::size_t leave_out_hidden(RenderScene& scene) {
    double highest = -geom::infinity;
    for (const Part& part : scene.parts) {
        if (part.is_member) highest = std::max(highest, part.priority);
    }
    const double room = room_to_spare(scene);
    std::vector<bool> is_hidden;
    for (const Part& part : scene.parts) {
        bool hidden = false;
        const auto look = [&](int index) {
            hidden = hidden || hides(scene.parts[std::size_t(index)], part, room);
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
