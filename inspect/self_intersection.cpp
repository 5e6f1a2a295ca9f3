#include "inspect/self_intersection.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

#include "geom/bvh.hpp"

namespace meniscus::inspect {
namespace {

using geom::Vec3;
using Corners = std::array<Vec3, 3>;

bool is_corner(const Corners& triangle, const Vec3& p) {
    return p == triangle[0] || p == triangle[1] || p == triangle[2];
}

struct Cut {
    Vec3 position;
    double depth;
};

/// Where the edge from p to q goes through the triangle, by more than `margin` on both sides of its
/// plane and inside all of its edges.
std::optional<Cut> cut(const Vec3& p, const Vec3& q, const Corners& t, double margin) {
    Vec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double area = glm::length(n);
    if (!(area > 0.0)) return std::nullopt;
    n /= area;
    const double before = glm::dot(p - t[0], n), behind = glm::dot(q - t[0], n);
    const double depth = std::min(std::abs(before), std::abs(behind));
    if ((before > 0.0) == (behind > 0.0) || depth <= margin) return std::nullopt;
    const Vec3 at = p + before / (before - behind) * (q - p);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = t[(i + 1) % 3] - t[i];
        const Vec3 inwards = glm::cross(n, edge);
        if (glm::dot(at - t[i], inwards) <= margin * glm::length(edge)) return std::nullopt;
    }
    return Cut{at, depth};
}

std::optional<Cut> cut(const Corners& edges_of, const Corners& triangle, double margin) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &p = edges_of[i], &q = edges_of[(i + 1) % 3];
        if (is_corner(triangle, p) || is_corner(triangle, q)) continue;
        if (auto found = cut(p, q, triangle, margin)) return found;
    }
    return std::nullopt;
}

struct ByCoordinates {
    bool operator()(const Vec3& a, const Vec3& b) const {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

/// For each triangle the number of its shell: those that share a corner are of one.
std::vector<std::size_t> shells(const geom::TriangleMesh& mesh) {
    std::vector<std::size_t> parent(mesh.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::map<Vec3, std::size_t, ByCoordinates> first;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        for (const Vec3& corner : mesh.corners(geom::Face(i))) {
            const auto [known, is_new] = first.try_emplace(corner, i);
            if (!is_new) parent[root(i)] = root(known->second);
        }
    }
    for (std::size_t i = 0; i < mesh.size(); ++i) parent[i] = root(i);
    return parent;
}

}  // namespace

std::optional<SelfIntersection> find_self_intersection(const geom::TriangleMesh& mesh) {
    const double margin = 64.0 * geom::unit_roundoff * mesh.magnitude();
    std::vector<geom::Bounds> boxes(mesh.size());
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        for (const Vec3& corner : mesh.corners(geom::Face(i))) boxes[i].extend(corner);
    }
    const geom::Bvh hierarchy(boxes);
    std::vector<std::size_t> shell_of;  // made when first needed
    std::optional<SelfIntersection> found;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        const Corners a = mesh.corners(geom::Face(i));
        hierarchy.overlapping(boxes[i], [&](std::uint32_t j) {
            if (j <= i || !geom::overlap(boxes[i], boxes[j])) return;
            const Corners b = mesh.corners(geom::Face(j));
            auto meets = cut(a, b, margin);
            if (!meets) meets = cut(b, a, margin);
            if (!meets) return;
            if (shell_of.empty()) shell_of = shells(mesh);
            if (shell_of[i] != shell_of[j]) return;
            if (!found) found = SelfIntersection{0, meets->position, a, b, meets->depth};
            ++found->pairs;
        });
    }
    return found;
}

}  // namespace meniscus::inspect
