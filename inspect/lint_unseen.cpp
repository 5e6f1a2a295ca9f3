// Solids that the scene holds and no picture shows.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "inspect/containment.hpp"
#include "inspect/lints.hpp"
#include "tracer/camera_rays.hpp"
#include "tracer/offers.hpp"

namespace meniscus::inspect {
namespace {

using geom::Vec3;
using tracer::Part;
using tracer::RenderScene;

const scene::Location& location(const RenderScene& scene, const Part& part) {
    return scene.source.objects[std::size_t(part.object)].location;
}

/// By which opaque part a clear part is hidden, and how sure that is.
struct Burial {
    const Part* by;
    Containment how;
};

std::map<int, Burial> buried_parts(const RenderScene& scene) {
    std::map<int, Burial> buried;
    const Vec3 from = tracer::camera_origin(scene.source.camera);
    for (const Part& outer : scene.parts) {
        // What stands in lists may be hollowed out by stronger solids.
        if (!outer.is_opaque || outer.is_member || outer.inverse || !outer.shape.is_closed())
            continue;
        if (outer.no_image || outer.no_reflection) continue;
        const geom::Bounds& bounds = outer.shape.bounds();
        if (!bounds.is_finite() || outer.shape.contains(from)) continue;
        scene.bvh.overlapping(bounds, [&](std::uint32_t primitive) {
            const int low = scene.bvh_parts[primitive];
            const Part& inner = scene.parts[std::size_t(low)];
            if (!inner.is_member || inner.is_opaque || buried.contains(low)) return;
            const Containment how = contained(inner, outer);
            if (how != Containment::no) buried[low] = {&outer, how};
        });
    }
    return buried;
}

/// How far apart two parallel planes can be at the least, of those along the sides of its own box,
/// with the whole part between them.
double thickness(const geom::PlacedShape& shape, Vec3 own_size) {
    const auto inverse = shape.transform().inverse().linear();
    double least = geom::infinity;
    for (int axis = 0; axis < 3; ++axis) {
        // the row of the inverse: what the coordinate along that side grows by, in the scene
        const Vec3 growth{inverse[0][axis], inverse[1][axis], inverse[2][axis]};
        least = std::min(least, own_size[axis] / glm::length(growth));
    }
    return least;
}

}  // namespace

void find_buried_solids(const RenderScene& scene, const Names& names,
                        std::vector<Finding>& findings) {
    const auto buried = buried_parts(scene);
    if (buried.empty()) return;
    std::map<int, std::vector<int>> parts_of;  // solid -> its parts
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        parts_of[scene.parts[i].solid].push_back(int(i));
    for (const auto& [solid, parts] : parts_of) {
        if (!std::ranges::all_of(parts, [&](int part) { return buried.contains(part); })) continue;
        const Part& part = scene.parts[std::size_t(parts.front())];
        const Part& outer = *buried.at(parts.front()).by;
        const bool is_certain = std::ranges::all_of(
            parts, [&](int i) { return buried.at(i).how == Containment::certain; });
        Finding finding;
        finding.lint = "buried-solid";
        finding.location = location(scene, part);
        finding.text = fmt::format("{} lies wholly inside {}, which is opaque{}: it is never seen",
                                   names.with_priority(solid), names.object(outer.object),
                                   is_certain ? "" : ", as far as sample lines show");
        finding.advice = "leave it out; or let it stick out, or make what is around it clear";
        finding.related = {{location(scene, outer), names.object(outer.object) + " is here"}};
        finding.position = part.shape.bounds().center();
        findings.push_back(std::move(finding));
    }
}

void find_thin_solids(const RenderScene& scene, const Names& names,
                      std::vector<Finding>& findings) {
    const Vec3 from = tracer::camera_origin(scene.source.camera);
    for (const Part& part : scene.parts) {
        const geom::Bounds& bounds = part.shape.bounds();
        if (!part.is_member || part.inverse || !bounds.is_finite()) continue;
        const Vec3 own_size =
            std::visit([](const auto& shape) { return shape.bounds().size(); }, part.shape.shape());
        const double thick = thickness(part.shape, own_size);
        // as the camera's rays have it (docs/numerics.md, "Coincident crossings")
        const double magnitude = geom::max_abs(from) + glm::length(bounds.center() - from) +
                                 std::max(geom::max_abs(bounds.low), geom::max_abs(bounds.high));
        const double tolerance = tracer::tolerance(scene, magnitude);
        if (!(thick <= tolerance)) continue;
        Finding finding;
        finding.lint = "thin-solid";
        finding.location = location(scene, part);
        finding.text = fmt::format(
            "{} is {} thin, and what lies within {} counts as one surface there: rays pass as if "
            "it were not there",
            names.object(part.object), text(thick), text(tolerance));
        finding.advice = "make it thicker";
        if (scene.contact_tolerance >= tolerance)
            finding.advice += ", or state a smaller contact_tolerance";
        finding.position = bounds.center();
        finding.depth = thick;
        findings.push_back(std::move(finding));
    }
}

}  // namespace meniscus::inspect
