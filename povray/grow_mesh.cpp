#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "povray/grow.hpp"

namespace meniscus::povray {
namespace {

using geom::Transform;
using geom::Vec3;

std::array<double, 3> key(const Vec3& p) { return {p.x, p.y, p.z}; }

/// Two triangles meet just if an edge of one passes through the other; those that share a corner
/// are left out, they meet there.
void require_no_meeting(const geom::TriangleMesh& mesh) {
    for (geom::Face face = 0; face < geom::Face(mesh.size()); ++face) {
        const auto corners = mesh.corners(face);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
            geom::Ray edge;
            edge.origin = a;
            edge.direction = b - a;
            geom::Crossings crossings;
            mesh.crossings(edge, crossings);
            for (const auto& crossing : crossings) {
                if (crossing.t <= 0.0 || crossing.t >= 1.0) continue;
                const auto other = mesh.corners(crossing.face);
                if (std::ranges::any_of(other, [&](const Vec3& p) { return p == a || p == b; }))
                    continue;
                throw std::invalid_argument("its surface would pass through itself");
            }
        }
    }
}

}  // namespace

geom::TriangleSoup soup_of(const geom::TriangleMesh& mesh, const Transform& transform) {
    constexpr auto none = geom::TriangleSoup::no_normal;
    geom::TriangleSoup soup;
    for (geom::Face face = 0; face < geom::Face(mesh.size()); ++face) {
        const auto first = std::uint32_t(soup.positions.size());
        const Vec3 flat = mesh.normal(face);
        bool is_smooth = false;
        for (const Vec3& p : mesh.corners(face)) {
            const Vec3 normal = mesh.shading_normal(face, p);
            is_smooth = is_smooth || glm::length(normal - flat) > 1e-9;
            soup.positions.push_back(transform.point(p));
            soup.normals.push_back(transform.normal(normal));
        }
        soup.triangles.push_back({first, first + 1, first + 2});
        soup.corner_normals.push_back(is_smooth ? soup.triangles.back()
                                                : geom::TriangleIndices{none, none, none});
    }
    return soup;
}

geom::TriangleSoup offset(const geom::TriangleMesh& mesh, double distance) {
    struct Vertex {
        Vec3 normal{0.0};    // angle-weighted
        double least = 1.0;  // its cosine with the faces around
    };
    std::map<std::array<double, 3>, Vertex> vertices;
    const auto count = geom::Face(mesh.size());
    for (geom::Face face = 0; face < count; ++face) {
        const auto p = mesh.corners(face);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 u = glm::normalize(p[(i + 1) % 3] - p[i]);
            const Vec3 v = glm::normalize(p[(i + 2) % 3] - p[i]);
            vertices[key(p[i])].normal +=
                std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0)) * mesh.normal(face);
        }
    }
    for (auto& [place, vertex] : vertices) vertex.normal = glm::normalize(vertex.normal);
    for (geom::Face face = 0; face < count; ++face) {
        for (const Vec3& p : mesh.corners(face)) {
            auto& vertex = vertices[key(p)];
            vertex.least = std::min(vertex.least, glm::dot(vertex.normal, mesh.normal(face)));
        }
    }

    geom::TriangleSoup soup = soup_of(mesh, Transform{});
    for (geom::Face face = 0; face < count; ++face) {
        Vec3* const p = soup.positions.data() + 3 * std::size_t(face);
        for (Vec3* corner = p; corner < p + 3; ++corner) {
            const auto& vertex = vertices[key(*corner)];
            if (!(vertex.least > 0.05)) throw std::invalid_argument("it has too sharp a corner");
            *corner += distance / vertex.least * vertex.normal;
        }
        if (!(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), mesh.normal(face)) > 0.0))
            throw std::invalid_argument("a triangle of it would turn over");
    }
    require_no_meeting(geom::TriangleMesh(soup));
    return soup;
}

}  // namespace meniscus::povray
