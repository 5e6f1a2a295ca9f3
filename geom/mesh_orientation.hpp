#pragma once

#include "geom/mesh_edges.hpp"
#include "geom/triangle_mesh.hpp"
#include "geom/weld.hpp"

namespace meniscus::geom {

/// Finds out whether a new mesh is closed and which side of it is the outer one, and turns
/// triangles round where they say otherwise.
class TriangleMesh::Orientation {
public:
    /// The triangles as those of the mesh, in the same order.
    Orientation(TriangleMesh& mesh, WeldedTriangles& welded)
        : mesh_(mesh), triangles_(welded.triangles), positions_(welded.positions) {}

    void run();

private:
    void orient_by_nesting(const std::vector<std::uint32_t>& part_of, std::size_t parts);
    void turn_shells_outward(const std::vector<std::uint32_t>& part_of, std::size_t parts);
    void flip(std::size_t triangle);
    std::array<Vec3, 3> corners(std::size_t triangle) const;
    double volume_under(std::size_t triangle) const;
    /// From the middle of a triangle outwards: all that lies ahead but the triangle itself.
    Crossings ahead_of(std::size_t triangle) const;

    TriangleMesh& mesh_;
    std::vector<TriangleIndices>& triangles_;
    const std::vector<Vec3>& positions_;
};

}  // namespace meniscus::geom
