#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "inspect/lints.hpp"
#include "inspect/sample_lines.hpp"
#include "inspect/self_intersection.hpp"

namespace meniscus::inspect {
namespace {

using tracer::Part;
using tracer::RenderScene;

const geom::Mesh* mesh_of(const Part& part) { return std::get_if<geom::Mesh>(&part.shape.shape()); }

/// Calls visit(part, mesh) once for each mesh, with the first part that uses it.
void visit_meshes(const RenderScene& scene, auto&& visit) {
    std::set<const geom::TriangleMesh*> seen;
    for (const Part& part : scene.parts) {
        const geom::Mesh* mesh = mesh_of(part);
        if (mesh && seen.insert(mesh->triangles.get()).second) visit(part, *mesh->triangles);
    }
}

/// Whether the scene means this object to be made of something.
bool is_meant_as_medium(const RenderScene& scene, const Part& part) {
    const auto& interior = scene.source.solids[std::size_t(part.solid)].interior;
    return interior.states_ior || interior.states_priority || interior.attenuates();
}

Finding about(const RenderScene& scene, const Part& part, std::string_view lint,
              Finding::Severity severity = Finding::Severity::warning) {
    Finding finding;
    finding.severity = severity;
    finding.lint = lint;
    finding.location = scene.source.objects[std::size_t(part.object)].location;
    return finding;
}

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

void find_open_meshes(const RenderScene& scene, const Names& names,
                      std::vector<Finding>& findings) {
    for (const Part& part : scene.parts) {
        const geom::Mesh* mesh = mesh_of(part);
        if (!mesh || mesh->is_closed() || !is_meant_as_medium(scene, part)) continue;
        const auto& stats = mesh->triangles->stats();
        Finding finding = about(scene, part, "open-mesh");
        finding.text = fmt::format("{} is not closed: {}", names.object(part.object),
                                   counted(stats.open_edges, "boundary edge"));
        if (!stats.first_open_edges.empty()) {
            const auto& edge = stats.first_open_edges.front();
            const auto a = part.shape.transform().point(edge.a);
            const auto b = part.shape.transform().point(edge.b);
            finding.text += fmt::format(", one from {} to {}", text(a), text(b));
            finding.position = 0.5 * (a + b);
        }
        finding.text += "; it is a surface and no solid, and its interior has no effect";
        finding.advice =
            "close the mesh (all faces, equal corners exactly equal), or leave out its interior";
        findings.push_back(std::move(finding));
    }
}

void find_repaired_meshes(const RenderScene& scene, const Names& names,
                          std::vector<Finding>& findings) {
    visit_meshes(scene, [&](const Part& part, const geom::TriangleMesh& mesh) {
        const auto& stats = mesh.stats();
        const auto& name = names.object(part.object);
        if (mesh.is_closed() && stats.was_inside_out) {
            Finding finding = about(scene, part, "inside-out-mesh");
            finding.position = part.shape.transform().point(mesh.corners(0)[0]);
            finding.text = fmt::format(
                "{} is inside out: its triangles are wound so that their normals point inwards; "
                "it is rendered the right way round",
                name);
            finding.advice = "turn the triangles round in the program that wrote them";
            findings.push_back(std::move(finding));
        }
        if (mesh.is_closed() && !stats.was_consistent) {
            Finding finding = about(scene, part, "inconsistent-mesh", Finding::Severity::note);
            finding.text = fmt::format(
                "{} has neighbouring triangles that are wound in opposite ways; {} turned round so "
                "that each surface toggles inside and outside",
                name, stats.flipped == 1 ? "1 was" : fmt::format("{} were", stats.flipped));
            finding.advice =
                "nothing need be done; a consistent winding would make overlapping shells count";
            findings.push_back(std::move(finding));
        }
        if (stats.degenerate > 0) {
            Finding finding = about(scene, part, "degenerate-triangles", Finding::Severity::note);
            finding.text = fmt::format("{} has {} without area; left out", name,
                                       counted(stats.degenerate, "triangle"));
            finding.advice = "nothing need be done as long as the mesh is closed";
            findings.push_back(std::move(finding));
        }
    });
}

void find_nested_shells(const RenderScene& scene, const Names& names,
                        std::vector<Finding>& findings) {
    visit_meshes(scene, [&](const Part& part, const geom::TriangleMesh& mesh) {
        if (!part.is_member || mesh.stats().components < 2) return;
        constexpr int lines_per_axis = 256;
        geom::Crossings crossings;
        for (const geom::Ray& line : sample_lines(mesh.bounds(), lines_per_axis)) {
            crossings.clear();
            mesh.crossings(line, crossings);
            int depth = 0;
            for (const auto& crossing : crossings) {
                depth += crossing.entering ? 1 : -1;
                if (depth < 2) continue;
                Finding finding = about(scene, part, "nested-shells", Finding::Severity::note);
                finding.position = part.shape.transform().point(line.at(crossing.t));
                finding.text = fmt::format(
                    "{} has shells that overlap, as at {}: they count as one solid, not as a "
                    "cavity",
                    names.object(part.object), text(*finding.position));
                finding.advice =
                    "for a cavity, wind the inner shell the other way or make it a solid of its "
                    "own: material { ior 1 } with a higher priority";
                findings.push_back(std::move(finding));
                return;
            }
        }
    });
}

void find_self_intersections(const RenderScene& scene, const Names& names,
                             std::vector<Finding>& findings) {
    visit_meshes(scene, [&](const Part& part, const geom::TriangleMesh& mesh) {
        if (!part.is_member) return;
        const auto found = find_self_intersection(mesh);
        if (!found) return;
        const auto& map = part.shape.transform();
        const auto corners = [&](const std::array<geom::Vec3, 3>& triangle) {
            return fmt::format("{} {} {}", text(map.point(triangle[0])),
                               text(map.point(triangle[1])), text(map.point(triangle[2])));
        };
        Finding finding = about(scene, part, "self-intersecting-mesh");
        finding.position = map.point(found->position);
        finding.depth = found->depth * map.largest_scale();
        finding.text = fmt::format(
            "{} cuts through itself: {} of triangles, as at {}, where the triangle {} meets {}",
            names.object(part.object), counted(found->pairs, "pair"), text(*finding.position),
            corners(found->triangle), corners(found->other));
        finding.advice =
            "mend the mesh; inside and outside are counted, so that a fold that is turned inside "
            "out is a hole";
        findings.push_back(std::move(finding));
    });
}

}  // namespace meniscus::inspect
