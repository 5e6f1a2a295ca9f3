#include "inspect/self_intersection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geom/bvh.hpp"
#include "inspect/mesh_surface.hpp"
#include "inspect/triangle_meeting.hpp"

namespace meniscus::inspect {
namespace {

using geom::Vec3;

class Search {
public:
    explicit Search(const geom::TriangleMesh& mesh)
        : mesh_(mesh), surface_(mesh), margin_(64.0 * geom::unit_roundoff * mesh.magnitude()) {
        triangles_.reserve(mesh.size());
        std::vector<geom::Bounds> boxes(mesh.size());
        for (std::size_t i = 0; i < mesh.size(); ++i) {
            triangles_.emplace_back(mesh.corners(geom::Face(i)));
            for (const Vec3& corner : triangles_[i].corners) boxes[i].extend(corner);
        }
        const geom::Bvh hierarchy(boxes);
        for (std::size_t i = 0; i < mesh.size(); ++i) {
            hierarchy.overlapping(boxes[i], [&](std::uint32_t j) {
                if (j > i && geom::overlap(boxes[i], boxes[j])) judge(i, j);
            });
        }
    }

    SelfIntersections found;

private:
    void judge(std::size_t a, std::size_t b) {
        const int shared = surface_.shared_corners(a, b);
        // Neighbours meet in their edge, unless one is folded back onto the other.
        if (shared == 2 && apex_height(b, a) != 0.0) return;
        const auto meeting = meet(triangles_[a], triangles_[b], margin_);
        if (const auto* segment = std::get_if<SharedSegment>(&meeting)) {
            if (const auto depth = depth_of_cut(a, b, *segment))
                note_cut(a, b, 0.5 * (segment->from + segment->to), *depth);
        } else if (const auto* area = std::get_if<SharedArea>(&meeting)) {
            note_area(a, b, shared == 3, *area);
        }
    }

    void note_area(std::size_t a, std::size_t b, bool same_corners, const SharedArea& area) {
        const std::uint32_t shell_a = surface_.shell(a), shell_b = surface_.shell(b);
        if (shell_a == shell_b) {
            note(area.same_facing ? found.overlaps : found.folds, a, b, area.center, area.width);
        } else if (same_corners && area.same_facing && is_twice_inside(a, area)) {
            note(found.repeated, a, b, area.center, area.width);
        }  // else they touch
    }

    /// Whether what the triangle bounds counts more than once just behind it.
    bool is_twice_inside(std::size_t triangle, const SharedArea& area) const {
        const double step = std::max(1e-6 * area.width, margin_);
        return mesh_.depth_at(area.center - step * mesh_.normal(geom::Face(triangle))) > 1;
    }

    double height(std::size_t over, const Vec3& p) const {
        return triangles_[over].height(p, margin_);
    }

    /// Of the corner that is not on the edge between the two, over the other's plane.
    double apex_height(std::size_t of, std::size_t over) const {
        return height(over, triangles_[of].corners[std::size_t(surface_.apex(of, over))]);
    }

    /// How deep the surfaces cut through each other along a segment that triangles of both share;
    /// nothing where they touch.
    std::optional<double> depth_of_cut(std::size_t a, std::size_t b,
                                       const SharedSegment& segment) const {
        if (segment.first_edge < 0 && segment.second_edge < 0)
            return segment.depth > 0.0 ? std::optional(segment.depth) : std::nullopt;
        if (segment.first_edge < 0) return depth_at_edge(b, segment.second_edge, a);
        if (segment.second_edge < 0) return depth_at_edge(a, segment.first_edge, b);
        return depth_between_edges(a, b, segment);
    }

    /// Along an edge of `a` within `b`: through if the neighbour there is on the other side.
    std::optional<double> depth_at_edge(std::size_t a, int edge, std::size_t b) const {
        const std::uint32_t other = surface_.neighbour(a, edge);
        if (other == MeshSurface::none) return std::nullopt;
        const double here = height(b, corner_off_edge(a, edge));
        const double there =
            height(b, triangles_[other].corners[std::size_t(surface_.apex(other, a))]);
        if (here * there >= 0.0) return std::nullopt;
        return std::min(std::abs(here), std::abs(there));
    }

    /// Along an edge of both, which are not the same: through if, seen along it, the one surface's
    /// two triangles are on both sides of the other's.
    std::optional<double> depth_between_edges(std::size_t a, std::size_t b,
                                              const SharedSegment& segment) const {
        const std::uint32_t beside_a = surface_.neighbour(a, segment.first_edge);
        const std::uint32_t beside_b = surface_.neighbour(b, segment.second_edge);
        if (beside_a == MeshSurface::none || beside_b == MeshSurface::none) return std::nullopt;
        if (beside_a == b) return std::nullopt;
        const Vec3 axis = glm::normalize(segment.to - segment.from);
        const auto across = [&](const Vec3& p) {
            const Vec3 e = p - segment.from;
            return e - glm::dot(e, axis) * axis;
        };
        const Vec3 start = across(corner_off_edge(a, segment.first_edge));
        const Vec3 x = glm::normalize(start), y = glm::cross(axis, x);
        double reach = glm::length(start);
        const auto angle = [&](const Vec3& p) {
            const Vec3 e = across(p);
            reach = std::min(reach, glm::length(e));
            const double turn = std::atan2(glm::dot(e, y), glm::dot(e, x));
            return turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn;
        };
        const auto apex = [&](std::uint32_t of, std::size_t beside) {
            return triangles_[of].corners[std::size_t(surface_.apex(of, beside))];
        };
        const double end = angle(apex(beside_a, a));
        const double one = angle(corner_off_edge(b, segment.second_edge));
        const double two = angle(apex(beside_b, b));
        // Triangles on each other are found as such.
        constexpr double least = 1e-9;
        for (const double turn : {one, two}) {
            if (std::abs(turn - end) < least || turn < least ||
                turn > 2.0 * std::numbers::pi - least)
                return std::nullopt;
        }
        if ((one < end) == (two < end)) return std::nullopt;
        return reach;
    }

    Vec3 corner_off_edge(std::size_t triangle, int edge) const {
        return triangles_[triangle].corners[std::size_t(edge + 2) % 3];
    }

    void note_cut(std::size_t a, std::size_t b, const Vec3& p, double depth) {
        const std::uint32_t shell_a = surface_.shell(a), shell_b = surface_.shell(b);
        if (shell_a == shell_b) return note(found.cuts, a, b, p, depth);
        const bool solids = !surface_.is_cavity(shell_a) && !surface_.is_cavity(shell_b);
        note(solids ? found.unions : found.pierced, a, b, p, depth);
    }

    void note(std::optional<TrianglePairs>& pairs, std::size_t a, std::size_t b, const Vec3& p,
              double depth) {
        if (!pairs) pairs = TrianglePairs{0, geom::Face(a), geom::Face(b), p, depth};
        ++pairs->count;
    }

    const geom::TriangleMesh& mesh_;
    MeshSurface surface_;
    std::vector<FlatTriangle> triangles_;
    double margin_;
};

}  // namespace

SelfIntersections self_intersections(const geom::TriangleMesh& mesh) { return Search(mesh).found; }

}  // namespace meniscus::inspect
