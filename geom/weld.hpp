#pragma once

#include <vector>

#include "geom/triangle_mesh.hpp"

namespace meniscus::geom {

/// Triangles that share the vertices in which they meet, and have three different ones each.
struct WeldedTriangles {
    std::vector<Vec3> positions;
    std::vector<TriangleIndices> triangles;
    std::vector<Vec3> normals;
    std::vector<TriangleIndices> corner_normals;  // empty, or the normals' numbers of each triangle
    std::vector<std::uint32_t> numbers;  // empty, or of each triangle its place in the soup
    std::size_t degenerate = 0, duplicate_positions = 0;
    std::optional<DegenerateTriangle> first_degenerate;
};

/// Makes equal positions one vertex and leaves out triangles without an area. Throws
/// std::invalid_argument as TriangleMesh does.
WeldedTriangles weld(TriangleSoup soup);

}  // namespace meniscus::geom
