#pragma once

#include "geom/mesh.hpp"
#include "lang/cursor.hpp"

namespace meniscus::lang {

/// The triangles of `mesh { ... }`, written out or in a file; what modifies the object follows.
std::variant<geom::Shape, MeshFile> read_mesh(Cursor& cursor, const Span& span);
/// Each file is loaded once.
geom::Mesh load_mesh_file(Session& session, const MeshFile& file);

/// The lists of `mesh2 { ... }`.
geom::Mesh read_mesh2(Cursor& cursor, const Span& span);

}  // namespace meniscus::lang
