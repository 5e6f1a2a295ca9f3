#pragma once

#include "geom/mesh.hpp"
#include "lang/cursor.hpp"

namespace meniscus::lang {

/// The triangles of `mesh { ... }`, written out or from a file; what modifies the object follows.
geom::Mesh read_mesh(Cursor& cursor, const Span& span);

/// The lists of `mesh2 { ... }`.
geom::Mesh read_mesh2(Cursor& cursor, const Span& span);

}  // namespace meniscus::lang
