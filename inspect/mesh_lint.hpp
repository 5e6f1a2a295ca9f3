#pragma once

#include <set>
#include <string>
#include <string_view>

#include "inspect/finding.hpp"
#include "inspect/names.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::inspect {

inline const geom::Mesh* mesh_of(const tracer::Part& part) {
    return std::get_if<geom::Mesh>(&part.shape.shape());
}

/// Calls visit(part, mesh) once for each mesh, with the first part that uses it.
void visit_meshes(const tracer::RenderScene& scene, auto&& visit) {
    std::set<const geom::TriangleMesh*> seen;
    for (const tracer::Part& part : scene.parts) {
        const geom::Mesh* mesh = mesh_of(part);
        if (mesh && seen.insert(mesh->triangles.get()).second) visit(part, *mesh->triangles);
    }
}

/// A finding at the place of the part's object in the text.
Finding about(const tracer::RenderScene& scene, const tracer::Part& part, std::string_view lint,
              Finding::Severity severity = Finding::Severity::warning);

/// "1 triangle", "2 triangles".
std::string counted(std::size_t count, std::string_view noun);

}  // namespace meniscus::inspect
