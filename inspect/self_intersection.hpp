#pragma once

#include <cstddef>
#include <optional>

#include "geom/triangle_mesh.hpp"

namespace meniscus::inspect {

/// Triangles of one mesh that meet, in one of the ways below.
struct TrianglePairs {
    std::size_t count = 0;
    geom::Face first = geom::no_face, second = geom::no_face;  // the first pair
    geom::Vec3 position{0.0};                                  // a point of both
    double depth = 0.0;  // how far they reach through each other there; of an overlap in one plane
                         // its width
};

/// What the triangles of a mesh do to each other, but for neighbours that meet where they should.
/// Shells are told apart by the edges that their triangles share.
struct SelfIntersections {
    std::optional<TrianglePairs> cuts;      // of one shell: through each other
    std::optional<TrianglePairs> overlaps;  // of one shell: on each other, facing the same way
    std::optional<TrianglePairs> folds;     // of one shell: on each other, back to back
    std::optional<TrianglePairs> repeated;  // of two shells: the same corners, both solid behind
    std::optional<TrianglePairs> unions;    // of two shells that both are solid
    std::optional<TrianglePairs> pierced;   // of a solid shell and a cavity, or of two cavities
};

/// All pairs are tested, by a hierarchy over their boxes. A surface passes through a triangle also
/// where it does so along an edge of its own or of the triangle, or from corner to corner: what
/// counts is that it goes on on the other side, by more than rounding. A surface that only touches
/// is no cut.
SelfIntersections self_intersections(const geom::TriangleMesh& mesh);

}  // namespace meniscus::inspect
