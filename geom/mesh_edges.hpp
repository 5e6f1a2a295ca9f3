#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/triangle_mesh.hpp"

namespace meniscus::geom {

/// One side of one triangle, running between two vertices.
struct EdgeUse {
    std::uint32_t low, high;  // vertices
    std::uint32_t triangle;
    bool forward;  // the triangle goes round from low to high
};

/// All sides of all triangles of so many vertices, those of one edge next to each other.
std::vector<EdgeUse> edge_uses(std::span<const TriangleIndices> triangles, std::size_t vertices);

/// Calls visit(span of EdgeUse) once for each edge.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit&& visit) {
    for (std::size_t begin = 0, end; begin < uses.size(); begin = end) {
        end = begin + 1;
        while (end < uses.size() && uses[end].low == uses[begin].low &&
               uses[end].high == uses[begin].high) {
            ++end;
        }
        visit(uses.subspan(begin, end - begin));
    }
}

/// How many more triangles run along the edge forwards than backwards. All edges of a closed mesh
/// give 0.
int imbalance(std::span<const EdgeUse> edge);

/// Triangles in parts: `of[triangle]` is its part's number.
struct MeshParts {
    std::vector<std::uint32_t> of;
    std::size_t count = 0;
};

/// Parts joined by edges, any number of triangles at each.
MeshParts connected_parts(std::size_t triangles, std::span<const EdgeUse> uses);

/// Parts joined by edges with just two triangles, and which triangles to flip so that within each
/// part all agree (as far as there is such a choice: a Moebius strip has none). The fewer triangles
/// of a part are flipped.
struct AgreedParts : MeshParts {
    std::vector<bool> flipped;
};
AgreedParts agree_on_winding(std::size_t triangles, std::span<const EdgeUse> uses);

}  // namespace meniscus::geom
