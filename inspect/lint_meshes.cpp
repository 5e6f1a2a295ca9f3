#include <fmt/format.h>

#include "inspect/lints.hpp"
#include "inspect/mesh_lint.hpp"

namespace meniscus::inspect {
namespace {

using tracer::Part;
using tracer::RenderScene;

/// Whether the scene means this object to be made of something.
bool is_meant_as_medium(const RenderScene& scene, const Part& part) {
    const auto& interior = scene.source.solids[std::size_t(part.solid)].interior;
    return interior.states_ior || interior.states_priority || interior.attenuates();
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
            const auto& first = *stats.first_degenerate;
            finding.position = part.shape.transform().point(first.corner);
            finding.triangles = {std::uint32_t(first.number)};
            finding.text = fmt::format(
                "{} has {} of which two corners are one, as triangle {} at {}; left out", name,
                counted(stats.degenerate, "triangle"), first.number, text(*finding.position));
            finding.advice = "nothing need be done as long as the mesh is closed";
            findings.push_back(std::move(finding));
        }
    });
}

}  // namespace meniscus::inspect
