#include "geom/weld.hpp"

#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace meniscus::geom {

namespace {

constexpr std::uint32_t none = 0xffffffff;

bool is_finite(const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Numbers positions, equal ones alike: a table with open addresses, at most half full.
class Numbering {
public:
    explicit Numbering(std::size_t most) : slots_(std::bit_ceil(2 * most + 2), none) {}

    std::uint32_t number_of(const Vec3& p) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = hash(p) & mask;
        for (; slots_[slot] != none; slot = (slot + 1) & mask) {
            if (positions_[slots_[slot]] == p) return slots_[slot];
        }
        positions_.push_back(p);
        return slots_[slot] = static_cast<std::uint32_t>(positions_.size() - 1);
    }
    std::size_t size() const { return positions_.size(); }
    std::vector<Vec3> take() { return std::move(positions_); }

private:
    static std::size_t hash(const Vec3& p) {
        std::uint64_t hash = 0;
        for (int i = 0; i < 3; ++i) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(p[i])) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return hash;
    }

    std::vector<std::uint32_t> slots_;
    std::vector<Vec3> positions_;
};

void check_normals(const TriangleSoup& soup) {
    if (soup.corner_normals.empty()) return;
    if (soup.corner_normals.size() != soup.triangles.size()) {
        throw std::invalid_argument(
            "a mesh must have normals for all of its triangles or for none");
    }
    for (const TriangleIndices& corners : soup.corner_normals) {
        for (const std::uint32_t n : corners) {
            if (n < soup.normals.size() || n == TriangleSoup::no_normal) continue;
            throw std::invalid_argument("a triangle of a mesh uses normal " + std::to_string(n) +
                                        ", but there are only " +
                                        std::to_string(soup.normals.size()));
        }
    }
}

}  // namespace

WeldedTriangles weld(TriangleSoup soup) {
    check_normals(soup);
    WeldedTriangles result;
    result.normals = std::move(soup.normals);
    Numbering numbering(soup.positions.size());
    std::vector<std::uint32_t> new_index(soup.positions.size(), none);
    std::size_t used = 0;
    const auto welded = [&](std::uint32_t old) {
        if (old >= soup.positions.size()) {
            throw std::invalid_argument("a triangle of a mesh uses vertex " + std::to_string(old) +
                                        ", but there are only " +
                                        std::to_string(soup.positions.size()));
        }
        if (new_index[old] != none) return new_index[old];
        const Vec3 p = soup.positions[old] + Vec3{0.0};  // makes -0 and 0 the same
        if (!is_finite(p)) throw std::invalid_argument("a vertex of a mesh is not finite");
        ++used;
        return new_index[old] = numbering.number_of(p);
    };

    const bool smooth = !soup.corner_normals.empty();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        TriangleIndices triangle = soup.triangles[i];
        for (std::uint32_t& corner : triangle) corner = welded(corner);
        const auto [a, b, c] = triangle;
        // One whose corners differ but lie on a line stays: it may join its neighbours.
        if (a == b || b == c || c == a) {
            if (!result.first_degenerate)
                result.first_degenerate = {i, soup.positions[soup.triangles[i][0]]};
            continue;
        }
        if (soup.is_numbered) result.numbers.push_back(static_cast<std::uint32_t>(i));
        soup.triangles[kept] = triangle;
        if (smooth) soup.corner_normals[kept] = soup.corner_normals[i];
        ++kept;
    }
    if (kept == 0) throw std::invalid_argument("a mesh has no triangle with an area");
    result.degenerate = soup.triangles.size() - kept;
    result.duplicate_positions = used - numbering.size();
    soup.triangles.resize(kept);
    if (smooth) soup.corner_normals.resize(kept);
    result.positions = numbering.take();
    result.triangles = std::move(soup.triangles);
    result.corner_normals = std::move(soup.corner_normals);
    return result;
}

}  // namespace meniscus::geom
