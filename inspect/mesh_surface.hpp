#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geom/triangle_mesh.hpp"

namespace meniscus::inspect {

/// How the triangles of a mesh hang together: found by their equal corners.
class MeshSurface {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    explicit MeshSurface(const geom::TriangleMesh& mesh);

    /// The triangle on the other side of an edge (from the corner of that number), if just two
    /// share it.
    std::uint32_t neighbour(std::size_t triangle, int edge) const {
        return neighbours_[triangle][std::size_t(edge)];
    }
    /// The corner of `triangle` that is not on the edge it shares with `other`, by its number.
    int apex(std::size_t triangle, std::size_t other) const;
    int shared_corners(std::size_t a, std::size_t b) const;

    /// The number of the triangle's shell: triangles are of one where they share an edge with no
    /// others, so that two closed shells that touch along an edge remain two.
    std::uint32_t shell(std::size_t triangle) const { return shells_[triangle]; }
    /// Whether the shell is wound inwards: a cavity.
    bool is_cavity(std::uint32_t shell) const { return volumes_[shell] < 0.0; }

private:
    std::vector<geom::TriangleIndices> triangles_;  // of welded corners
    std::vector<std::array<std::uint32_t, 3>> neighbours_;
    std::vector<std::uint32_t> shells_;
    std::vector<double> volumes_;  // of the shells
};

}  // namespace meniscus::inspect
