#pragma once

#include "geom/triangle_mesh.hpp"
#include "povray/writer.hpp"

namespace meniscus::povray {

/// The lists of a mesh2 block.
void write_triangles(Writer& writer, const geom::TriangleMesh& mesh);

}  // namespace meniscus::povray
