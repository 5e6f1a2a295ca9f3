#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geom/bounds.hpp"
#include "geom/bvh_node.hpp"
#include "geom/crossing.hpp"
#include "geom/mesh_search.hpp"
#include "geom/ray.hpp"
#include "geom/triangle_blocks.hpp"

namespace meniscus::geom {

/// Triangles as a file or a scene gives them. Equal positions need not share an index: they are
/// welded.
struct TriangleSoup {
    static constexpr std::uint32_t no_normal = 0xffffffff;

    std::vector<Vec3> positions;
    std::vector<TriangleIndices> triangles;
    std::vector<Vec3> normals;  // to shade with; of any length
    std::vector<TriangleIndices>
        corner_normals;        // empty, or for each triangle three normals or three `no_normal`
    bool is_numbered = false;  // whether the mesh is to remember the triangles' places in here
};

/// An edge that keeps a mesh from being closed.
struct OpenEdge {
    Vec3 a, b;
    int uses;  // by how many triangles
};

/// A triangle of which two corners are one.
struct DegenerateTriangle {
    std::size_t number;  // in the soup
    Vec3 corner;
};

/// What was found out about a mesh when it was built.
struct MeshStats {
    std::size_t triangles = 0, vertices = 0;  // that remain
    std::size_t degenerate = 0, duplicate_positions = 0;
    std::optional<DegenerateTriangle> first_degenerate;
    std::size_t components = 0;              // parts that share no edge
    std::size_t open_edges = 0;              // not used equally often in both directions
    std::vector<OpenEdge> first_open_edges;  // at most 8 of them
    std::size_t flipped = 0;      // triangles turned round to make the winding consistent
    bool was_consistent = true;   // neighbours agreed on their winding as given
    bool was_inside_out = false;  // they did, but all the wrong way round
    double volume = 0.0;
};

struct WeldedTriangles;

/// Triangles with a hierarchy over them, ready for rays; never changes. If every edge is used
/// equally often in both directions the mesh is closed, and every line then crosses it inwards as
/// often as outwards: the test is exact (see watertight.hpp).
///
/// A consistent winding is believed (turned round as a whole if the volume is negative): shells
/// then count. Any other winding is worked out anew by POV-Ray's rule that each surface crossed
/// toggles inside and outside: a shell within a shell is a cavity.
class TriangleMesh {
public:
    /// Throws std::invalid_argument if an index is out of range, a position is not finite, or no
    /// triangle remains.
    explicit TriangleMesh(TriangleSoup soup);

    /// The cube from -1 to 1.
    static std::shared_ptr<const TriangleMesh> unit_cube();

    bool is_closed() const { return stats_.open_edges == 0; }
    const MeshStats& stats() const { return stats_; }
    const Bounds& bounds() const { return bounds_; }
    double magnitude() const { return magnitude_; }
    std::size_t memory_bytes() const;

    std::size_t size() const { return blocks_.size(); }
    std::array<Vec3, 3> corners(Face face) const { return blocks_.corners(face); }
    /// The triangle's place in the soup, counted from 0, if that was to be remembered.
    std::optional<std::uint32_t> number(Face face) const {
        return numbers_.empty() ? std::nullopt : std::optional(numbers_[std::size_t(face)]);
    }

    /// Every crossing on the ray's whole line, sorted by t.
    void crossings(const Ray& ray, Crossings& out) const;
    /// The crossings that a search wants, sorted by t.
    void crossings(const Ray& ray, const Search& search, Crossings& out) const;
    /// Of a closed mesh, the crossings with t > 0 that a search wants, but for its `own`, sorted by
    /// t. Returns false where they contradict the depth from which the ray starts (if that is
    /// known), where the line does not cross its `own` as the search says (if it asks for that),
    /// or where rounding may have put them out of turn, or behind the origin, as far back as the
    /// search goes: then only the whole line tells.
    bool crossings_ahead(const Ray& ray, const Search& search, std::optional<int> depth,
                         Crossings& out) const;
    /// The crossings that each search wants, found together.
    void crossings(std::span<SearchedRay> rays) const;
    /// What `crossings_ahead` returns of what was found from `begin` on; takes out the search's
    /// `own`.
    bool fits(const Ray& ray, const Search& search, std::optional<int> depth, std::size_t begin,
              Crossings& found) const;
    int depth_at(const Vec3& p) const;
    /// One of a face's corners, and its normal.
    struct FacePlane {
        Vec3 corner, normal;
    };
    FacePlane plane(Face face) const;
    Vec3 normal(Face face) const { return plane(face).normal; }
    /// Whether it is shaded with other normals than that.
    bool is_smooth() const { return !corner_normals_.empty(); }
    Vec3 shading_normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;

private:
    // What is needed only until the mesh is built: see mesh_orientation.cpp.
    class Orientation;

    void build_hierarchy(WeldedTriangles& welded);
    bool takes_turns(const Ray& ray, const Crossings& ahead, std::size_t begin, int depth,
                     double end) const;
    double turn_tolerance(const Ray& ray, double furthest) const;

    TriangleBlocks blocks_;  // in the order of the hierarchy's leaves
    HugeVector<BvhNode> nodes_;
    std::vector<Vec3> normals_;
    std::vector<TriangleIndices> corner_normals_;
    std::vector<std::uint32_t> numbers_;
    Bounds bounds_;
    BvhFrame frame_;
    double magnitude_ = 0.0;
    MeshStats stats_;
};

}  // namespace meniscus::geom
