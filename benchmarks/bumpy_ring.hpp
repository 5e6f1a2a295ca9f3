#pragma once

#include <filesystem>

#include "geom/triangle_mesh.hpp"

namespace meniscus::geom {

/// A ring with bumps, about the y axis: no two triangles are alike.
TriangleSoup bumpy_ring(std::size_t triangles);

/// As .obj, .ply or .stl.
void write(const TriangleSoup& soup, const std::filesystem::path& path);

}  // namespace meniscus::geom
