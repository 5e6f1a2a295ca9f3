#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geom/triangle_mesh.hpp"

namespace meniscus::inspect {

/// Triangles of one shell that cut through each other.
struct SelfIntersection {
    std::size_t pairs = 0;                          // how many pairs of triangles do
    geom::Vec3 position{0.0};                       // a point of both of the first pair
    std::array<geom::Vec3, 3> triangle{}, other{};  // the first pair
    double depth = 0.0;                             // how far a corner reaches through, there
};

/// All pairs are tested, by a hierarchy over their boxes; only what goes through by more than
/// rounding counts, so that touching and sharing corners or edges is no cut. Shells that cut each
/// other, as in a union, are no fault, and not looked for.
std::optional<SelfIntersection> find_self_intersection(const geom::TriangleMesh& mesh);

}  // namespace meniscus::inspect
