#pragma once

#include <cstdint>

#include "geom/triangle_mesh.hpp"

namespace meniscus::geom {

struct Parity {
    std::uint64_t lines = 0, crossings = 0;
    std::uint64_t unbalanced = 0;   // not entered as often as left
    std::uint64_t out_of_turn = 0;  // entering and leaving do not take turns
};

/// Shoots lines at the vertices and edges of closed meshes: an icosphere, a gridded box, a torus
/// and a large icosphere, about the origin and at (148376, 1234, -223423). A quarter of the lines
/// each: through a vertex, through the middle of an edge, through any point of an edge, from a
/// vertex to another; a fifth of them along an axis; from near, far and from the surface itself.
Parity mesh_parity(std::uint64_t lines, unsigned seed);

}  // namespace meniscus::geom
