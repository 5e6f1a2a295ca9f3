#pragma once

#include <filesystem>
#include <memory>

#include "geom/triangle_mesh.hpp"

namespace meniscus::lang {

/// Reads all triangles of a file: Wavefront .obj, Stanford .ply, or any format that Assimp knows,
/// such as .stl. Polygons are triangulated, materials ignored, coordinates taken as they stand.
/// A numbered mesh remembers the order of its triangles in the file. Throws std::runtime_error with
/// a sentence that names the file.
std::shared_ptr<const geom::TriangleMesh> load_mesh(const std::filesystem::path& path,
                                                    bool is_numbered = false);

}  // namespace meniscus::lang
