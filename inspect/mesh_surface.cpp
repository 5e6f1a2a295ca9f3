#include "inspect/mesh_surface.hpp"

#include <algorithm>
#include <span>

#include "geom/mesh_edges.hpp"
#include "geom/weld.hpp"

namespace meniscus::inspect {

using geom::Vec3;

MeshSurface::MeshSurface(const geom::TriangleMesh& mesh)
    : neighbours_(mesh.size(), {none, none, none}) {
    geom::TriangleSoup soup;
    soup.positions.reserve(3 * mesh.size());
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        const auto first = std::uint32_t(soup.positions.size());
        for (const Vec3& corner : mesh.corners(geom::Face(i))) soup.positions.push_back(corner);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const auto welded = geom::weld(std::move(soup));
    triangles_ = welded.triangles;

    const auto uses = geom::edge_uses(triangles_, welded.positions.size());
    const auto put = [&](const geom::EdgeUse& use, std::uint32_t other) {
        const auto& corners = triangles_[use.triangle];
        const std::uint32_t from = use.forward ? use.low : use.high;
        const auto edge = std::ranges::find(corners, from) - corners.begin();
        neighbours_[use.triangle][std::size_t(edge)] = other;
    };
    geom::for_each_edge(uses, [&](std::span<const geom::EdgeUse> edge) {
        if (edge.size() != 2) return;
        put(edge[0], edge[1].triangle);
        put(edge[1], edge[0].triangle);
    });

    const auto parts = geom::agree_on_winding(triangles_.size(), uses);
    shells_ = parts.of;
    volumes_.assign(parts.count, 0.0);
    const Vec3 middle = mesh.bounds().center();
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto [a, b, c] = mesh.corners(geom::Face(i));
        volumes_[shells_[i]] += glm::dot(a - middle, glm::cross(b - middle, c - middle));
    }
}

int MeshSurface::apex(std::size_t triangle, std::size_t other) const {
    for (int i = 0; i < 3; ++i) {
        if (std::ranges::count(triangles_[other], triangles_[triangle][std::size_t(i)]) == 0)
            return i;
    }
    return 0;  // two triangles of the same corners
}

int MeshSurface::shared_corners(std::size_t a, std::size_t b) const {
    int shared = 0;
    for (const std::uint32_t corner : triangles_[a])
        shared += std::ranges::count(triangles_[b], corner) > 0;
    return shared;
}

}  // namespace meniscus::inspect
