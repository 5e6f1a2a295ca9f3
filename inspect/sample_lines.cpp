#include "inspect/sample_lines.hpp"

#include <algorithm>

#include "tracer/sampler.hpp"

namespace meniscus::inspect {
namespace {

using geom::Bounds;
using geom::infinity;
using geom::Vec3;
using tracer::Part;

/// What the part's solid may fill.
Bounds region(const Part& part) {
    return part.inverse ? Bounds::everything() : part.shape.bounds();
}

double size(const Bounds& bounds) { return glm::length(bounds.size()); }

/// A finite box that holds what there is to see.
Bounds world(const tracer::RenderScene& scene) {
    Bounds box = scene.bvh.bounds();
    box.extend(scene.source.camera.location);
    return box.padded(std::max(1.0, 0.5 * size(box)));
}

Bounds intersection(const Bounds& a, const Bounds& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

}  // namespace

std::vector<Inside> inside(const Part& part, const geom::Ray& line) {
    geom::Crossings crossings;
    part.shape.crossings(line, crossings);
    // How deep the line is inside far behind its origin: of unbounded shapes the origin tells.
    int depth = 0;
    if (!part.shape.bounds().is_finite()) {
        depth = part.shape.depth_at(line.origin);
        for (const auto& crossing : crossings) {
            if (crossing.t < 0.0) depth += crossing.entering ? -1 : 1;
        }
    }
    const auto is_in = [&] { return (depth > 0) != part.inverse; };
    std::vector<Inside> result;
    bool was_in = is_in();
    if (was_in) result.push_back({-infinity, infinity, geom::no_face, geom::no_face});
    for (const auto& crossing : crossings) {
        depth += crossing.entering ? 1 : -1;
        if (is_in() == was_in) continue;
        was_in = !was_in;
        if (was_in) {
            result.push_back({crossing.t, infinity, crossing.face, geom::no_face});
        } else {
            result.back().end = crossing.t;
            result.back().last = crossing.face;
        }
    }
    return result;
}

std::vector<geom::Ray> sample_lines(const Bounds& box, int lines_per_axis) {
    std::vector<geom::Ray> lines;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < lines_per_axis; ++i) {
            const geom::Vec2 at = tracer::SobolSet(std::uint64_t(axis)).point(std::uint32_t(i));
            Vec3 share{0.4142135623730951};
            share[(axis + 1) % 3] = at.x;
            share[(axis + 2) % 3] = at.y;
            geom::Ray line;
            line.origin = box.low + share * box.size();
            line.direction = Vec3{0.0};
            line.direction[axis] = 1.0;
            lines.push_back(line);
        }
    }
    return lines;
}

std::vector<std::pair<int, int>> neighbours(const tracer::RenderScene& scene, double margin,
                                            Pairing pairing) {
    std::vector<std::pair<int, int>> pairs;
    const auto add = [&](int a, int b) {
        const Part& first = scene.parts[std::size_t(a)];
        const Part& second = scene.parts[std::size_t(b)];
        if (!(a < b) || !first.is_member || !second.is_member) return;
        if (pairing == Pairing::all || first.solid != second.solid) pairs.emplace_back(a, b);
    };
    const auto is_everywhere = [&](int i) {
        return !region(scene.parts[std::size_t(i)]).is_finite();
    };
    const int count = int(scene.parts.size());
    for (int a = 0; a < count; ++a) {
        const Part& part = scene.parts[std::size_t(a)];
        if (!part.is_member) continue;
        if (is_everywhere(a)) {
            for (int b = 0; b < count; ++b) {
                if (b != a && (!is_everywhere(b) || a < b)) add(std::min(a, b), std::max(a, b));
            }
        } else {
            const Bounds near = part.shape.bounds().padded(margin * size(part.shape.bounds()));
            scene.bvh.overlapping(near, [&](std::uint32_t primitive) {
                const int b = scene.bvh_parts[primitive];
                if (!is_everywhere(b)) add(a, b);
            });
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

Bounds common_region(const tracer::RenderScene& scene, const Part& a, const Part& b,
                     double margin) {
    const auto padded = [&](const Part& part) {
        const Bounds bounds = region(part);
        return bounds.is_finite() ? bounds.padded(margin * size(bounds)) : bounds;
    };
    const Bounds common = intersection(padded(a), padded(b));
    return common.is_finite() ? common : intersection(common, world(scene));
}

}  // namespace meniscus::inspect
