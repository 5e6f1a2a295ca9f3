#include "povray/exactness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "inspect/sample_lines.hpp"
#include "povray/apart.hpp"
#include "povray/directions.hpp"
#include "povray/error.hpp"
#include "povray/flush.hpp"

namespace meniscus::povray {
namespace {

/// Whether a ray of many in all directions from the camera meets nothing opaque and ends up in the
/// part for ever.
bool lets_rays_to_the_sky(const tracer::RenderScene& scene, const tracer::Part& part) {
    constexpr int directions = 1024;
    geom::Ray ray;
    ray.origin = scene.source.camera.location;
    const auto is_met = [&](const tracer::Part& other) {
        geom::Crossings crossings;
        if (other.is_opaque) other.shape.crossings(ray, crossings);
        return std::ranges::any_of(crossings, [](const auto& c) { return c.t > 0.0; });
    };
    for (int i = 0; i < directions; ++i) {
        ray.direction = spread_direction(i, directions);
        const auto far = ray.origin + 1e9 * scene.size * ray.direction;
        if (part.shape.contains(far) != part.inverse && std::ranges::none_of(scene.parts, is_met))
            return true;
    }
    return false;
}

/// Whether an open surface lies in the solid's own wall, as far as lines find that.
bool lies_in_wall(const tracer::RenderScene& scene, const tracer::Part& solid,
                  const tracer::Part& open) {
    const double margin = touching_distance(scene);
    const auto box = inspect::common_region(scene, solid, open, 1e-3);
    for (const auto& line : inspect::sample_lines(box, 64)) {
        geom::Crossings hits;
        open.shape.hits(line, hits);
        if (hits.empty()) continue;
        for (const auto& [begin, end, first, last] : inspect::inside(solid, line)) {
            for (const auto& hit : hits) {
                if (std::abs(hit.t - begin) <= margin || std::abs(hit.t - end) <= margin)
                    return true;
            }
        }
    }
    return false;
}

void doubt_labels(const tracer::RenderScene& scene, const Plan& plan, const Body& body,
                  std::vector<std::string>& lines) {
    for (const int mine : body.parts) {
        for (const int other : plan.plain_parts) {
            const auto& part = scene.parts[std::size_t(mine)];
            const auto& open = scene.parts[std::size_t(other)];
            if (are_apart(part, open, touching_distance(scene))) continue;
            const auto& label = scene.source.objects[std::size_t(open.object)];
            if (open.shape.is_closed()) {
                const Flush flush = flush_faces(scene, part, open);
                if (flush.flat.empty() && !flush.curved) continue;
                lines.push_back(fmt::format(
                    "{}:{}: '{}' ends level with '{}', where they overlap: which of the two "
                    "POV-Ray sees is left to rounding; move one of them by {:.0g}",
                    label.location.file, label.location.line, label.name,
                    scene.source.solids[std::size_t(body.solid)].name, 1e-4 * scene.size));
                continue;
            }
            if (!lies_in_wall(scene, part, open)) continue;
            lines.push_back(fmt::format(
                "{}:{}: the open surface '{}' lies in the wall of '{}', which covers it in "
                "POV-Ray or not, by rounding; move it out by {:.0g}",
                label.location.file, label.location.line, label.name,
                scene.source.solids[std::size_t(body.solid)].name, 1e-4 * scene.size));
        }
    }
}

}  // namespace

void require_exact(const tracer::RenderScene& scene, const Plan& plan) {
    using tracer::Part;
    const auto location = [&](int part) {
        return scene.source.objects[std::size_t(scene.parts[std::size_t(part)].object)].location;
    };
    for (const Body& body : plan.bodies) {
        if (body.is_outside) continue;
        const auto& interior = scene.source.solids[std::size_t(body.solid)].interior;
        const bool has_neighbours = !body.higher.empty() || !body.lower.empty();
        for (const int index : body.parts) {
            const Part& part = scene.parts[std::size_t(index)];
            if (has_neighbours && (part.no_image || part.no_reflection)) {
                throw ExportError(location(index),
                                  "no_image and no_reflection on a solid that meets others "
                                  "cannot be exported: POV-Ray would still let it cut them");
            }
            if (part.no_shadow && interior.attenuates()) {
                throw ExportError(location(index),
                                  "no_shadow on an absorbing solid cannot be exported: "
                                  "POV-Ray's shadow rays would not be absorbed");
            }
        }
        if (interior.caustics != 0.0 && has_neighbours) {
            throw ExportError(scene.source.solids[std::size_t(body.solid)].location,
                              "caustics cannot be exported: POV-Ray brightens at each cut "
                              "face once more");
        }
    }
    for (const int index : plan.plain_parts) {
        const Part& part = scene.parts[std::size_t(index)];
        if (!part.is_opaque && !plan.bodies.empty()) {
            throw ExportError(location(index),
                              "an open surface that lets light through cannot be exported "
                              "beside dielectrics: POV-Ray takes it for the bound of a solid");
        }
    }
}

std::vector<std::string> doubts(const tracer::RenderScene& scene, const Plan& plan) {
    std::vector<std::string> lines;
    for (const Body& body : plan.bodies) {
        doubt_labels(scene, plan, body, lines);
        const auto& solid = scene.source.solids[std::size_t(body.solid)];
        const bool is_endless = std::ranges::any_of(body.parts, [&](int index) {
            const tracer::Part& part = scene.parts[std::size_t(index)];
            return (part.inverse || !part.shape.bounds().is_finite()) &&
                   lets_rays_to_the_sky(scene, part);
        });
        if (body.is_outside || !is_endless || !solid.interior.attenuates()) continue;
        lines.push_back(
            fmt::format("{}:{}: '{}' absorbs and has no end: rays that run in it to the sky keep "
                        "their light in "
                        "POV-Ray; let it end, or something opaque stand behind",
                        solid.location.file, solid.location.line, solid.name));
    }
    return lines;
}

}  // namespace meniscus::povray
