#include "geom/triangle_mesh.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/bvh_builder.hpp"
#include "geom/cylindrical.hpp"
#include "geom/mesh_orientation.hpp"
#include "geom/triangle.hpp"
#include "geom/weld.hpp"

namespace meniscus::geom {

namespace {

/// Crossings may be in the wrong order that are nearer to each other than so many u M.
constexpr double turn_units = 4096.0;

/// Along no axis, no diagonal and no edge that anyone would draw.
const Vec3 odd_direction{0.5377104, 0.7436219, 0.3973607};

/// Crossings that rounding has put in the wrong order, at edges and vertices, are put right:
/// nothing is left before it is entered, and a shell is left before it is entered again.
void take_turns(Crossings& crossings, std::size_t begin, double tolerance) {
    const auto swap_kind = [&](std::size_t i, std::size_t j) {
        std::swap(crossings[i].face, crossings[j].face);
        std::swap(crossings[i].entering, crossings[j].entering);
    };
    int depth = 0;
    for (std::size_t i = begin; i < crossings.size(); ++i) {
        const bool wanted = depth == 0;  // entering
        if (crossings[i].entering != wanted && (wanted || depth == 1)) {
            for (std::size_t j = i + 1;
                 j < crossings.size() && crossings[j].t - crossings[i].t <= tolerance; ++j) {
                if (crossings[j].entering == wanted) {
                    swap_kind(i, j);
                    break;
                }
            }
        }
        depth += crossings[i].entering ? 1 : -1;
    }
}

void sort(Crossings& crossings, std::size_t begin) {
    std::sort(crossings.begin() + begin, crossings.end(), [](const Crossing& a, const Crossing& b) {
        return a.t < b.t || (a.t == b.t && a.face < b.face);
    });
}

/// What a search has found up to its `end`, sorted.
void keep_in_order(Crossings& found, std::size_t begin, const Search& search, double end) {
    if (end < search.to) {
        const auto last = std::remove_if(found.begin() + begin, found.end(),
                                         [&](const Crossing& one) { return one.t > end; });
        found.resize(static_cast<std::size_t>(last - found.begin()));
    }
    if (found.size() > begin + 1) sort(found, begin);
}

}  // namespace

TriangleMesh::TriangleMesh(TriangleSoup soup) {
    WeldedTriangles welded = weld(std::move(soup));
    normals_ = std::move(welded.normals);
    if (normals_.empty()) welded.corner_normals = {};
    stats_.degenerate = welded.degenerate;
    stats_.first_degenerate = welded.first_degenerate;
    stats_.duplicate_positions = welded.duplicate_positions;
    build_hierarchy(welded);
    stats_.triangles = welded.triangles.size();
    stats_.vertices = welded.positions.size();
    Orientation(*this, welded).run();
}

void TriangleMesh::build_hierarchy(WeldedTriangles& welded) {
    for (const Vec3& p : welded.positions) bounds_.extend(p);
    frame_ = BvhFrame(bounds_);
    magnitude_ = std::max(max_abs(bounds_.low), max_abs(bounds_.high));
    const std::vector<TriangleIndices>& triangles = welded.triangles;
    std::vector<BuildItem> items(triangles.size());
    tbb::parallel_for(std::size_t{0}, items.size(), [&](std::size_t i) {
        Bounds box;
        for (const std::uint32_t corner : triangles[i]) box.extend(welded.positions[corner]);
        items[i] = BuildItem(box, frame_.center, static_cast<std::uint32_t>(i));
    });
    nodes_ = build_bvh(items, TriangleBlock<double>::width);
    const auto reorder = [&]<class Item>(std::vector<Item>& list) {
        if (list.empty()) return;
        std::vector<Item> sorted(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) sorted[i] = list[items[i].index()];
        list = std::move(sorted);
    };
    reorder(welded.triangles);
    reorder(welded.corner_normals);
    reorder(welded.numbers);
    corner_normals_ = std::move(welded.corner_normals);
    numbers_ = std::move(welded.numbers);
    blocks_ = TriangleBlocks(welded.positions, welded.triangles);
}

std::size_t TriangleMesh::memory_bytes() const {
    const auto bytes = [](const auto& list) { return list.size() * sizeof(list[0]); };
    return blocks_.memory_bytes() + bytes(nodes_) + bytes(normals_) + bytes(corner_normals_) +
           bytes(numbers_);
}

void TriangleMesh::crossings(const Ray& ray, const Search& search, Crossings& out) const {
    const std::size_t begin = out.size();
    const double end = find_crossings({nodes_.data(), frame_, blocks_}, ray, search, out);
    keep_in_order(out, begin, search, end);
}

void TriangleMesh::crossings(std::span<SearchedRay> rays) const {
    find_crossings({nodes_.data(), frame_, blocks_}, rays);
    for (SearchedRay& ray : rays) keep_in_order(ray.found, 0, ray.search, ray.end);
}

/// Two crossings that are nearer than this may be in the wrong order.
double TriangleMesh::turn_tolerance(const Ray& ray, double furthest) const {
    const double length = glm::length(ray.direction);
    return turn_units * unit_roundoff * (max_abs(ray.origin) + magnitude_ + furthest * length) /
           length;
}

void TriangleMesh::crossings(const Ray& ray, Crossings& out) const {
    const std::size_t begin = out.size();
    crossings(ray, Search{}, out);
    if (!is_closed() || out.size() < begin + 2) return;
    const double furthest = std::max(std::fabs(out[begin].t), std::fabs(out.back().t));
    take_turns(out, begin, turn_tolerance(ray, furthest));
}

bool TriangleMesh::crossings_ahead(const Ray& ray, const Search& search, std::optional<int> depth,
                                   Crossings& out) const {
    const std::size_t begin = out.size();
    crossings(ray, search, out);
    return fits(ray, search, depth, begin, out);
}

bool TriangleMesh::fits(const Ray& ray, const Search& search, std::optional<int> depth,
                        std::size_t begin, Crossings& out) const {
    if (search.own_met &&
        (search.own_met->face != search.own || search.own_met->entering != search.own_entering))
        return false;
    // What the ray was born on may come first; behind another crossing it would be no mere
    // rounding.
    if (search.own_met) {
        if (out.size() > begin && out[begin].t <= search.own_met->t) return false;
    } else if (search.own != no_face) {
        for (std::size_t i = out.size(); i-- > begin;) {
            if (out[i].face != search.own) continue;
            if (i != begin) return false;
            out.erase(i);
        }
    }
    if (out.size() == begin) return depth.value_or(0) == 0 || search.to < infinity;
    if (!(out[begin].t > 0.0)) return false;
    const bool starts_inside = !out[begin].entering;
    if (depth && starts_inside != (*depth > 0)) return false;
    return takes_turns(ray, out, begin, depth.value_or(starts_inside), search.to);
}

/// Whether no two crossings are so near that they may be in the wrong order; `end` is where the
/// search has stopped.
bool TriangleMesh::takes_turns(const Ray& ray, const Crossings& ahead, std::size_t begin, int depth,
                               double end) const {
    // Twice `turn_tolerance`, as far as the line meets the mesh at all, before and behind; in
    // squares, for there is hardly a ray that is not asked.
    const double reach = max_abs(ray.origin) + magnitude_ + 2.0 * frame_.reach;
    const double tolerance = 4.0 * turn_units * unit_roundoff * reach;
    const double shortest = tolerance * tolerance / glm::dot(ray.direction, ray.direction);
    for (std::size_t i = begin; i < ahead.size(); ++i) {
        const bool out_of_turn = ahead[i].entering == (depth > 0);
        depth += ahead[i].entering ? 1 : -1;
        if (out_of_turn && !ahead[i].entering) return false;
        // A depth that the first does not contradict its neighbour may.
        if (!out_of_turn && i != begin) continue;
        const double way = (i + 1 < ahead.size() ? ahead[i + 1].t : end) - ahead[i].t;
        if (way * way <= shortest) return false;
    }
    return true;
}

int TriangleMesh::depth_at(const Vec3& p) const {
    if (!bounds_.contains(p)) return 0;
    Crossings found;
    find_crossings({nodes_.data(), frame_, blocks_}, Ray{p, odd_direction}, {.from = 0.0}, found);
    int depth = 0;
    for (const Crossing& crossing : found) depth += crossing.entering ? -1 : 1;
    return depth;
}

TriangleMesh::FacePlane TriangleMesh::plane(Face face) const {
    const auto [a, b, c] = corners(face);
    const Vec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    return {a, length > 0.0 ? n / length : any_perpendicular(b - a)};
}

Vec3 TriangleMesh::shading_normal(Face face, const Vec3& p) const {
    const Vec3 flat = normal(face);
    if (corner_normals_.empty()) return flat;
    const auto [a, b, c] = corner_normals_[face];
    if (a == TriangleSoup::no_normal || b == TriangleSoup::no_normal ||
        c == TriangleSoup::no_normal) {
        return flat;
    }
    return interpolated_normal(corners(face), {normals_[a], normals_[b], normals_[c]}, flat, p);
}

Vec3 TriangleMesh::to_face(Face face, const Ray& point) const {
    const FacePlane plane = this->plane(face);
    return to_plane(point.from(plane.corner), plane.normal);
}

std::shared_ptr<const TriangleMesh> TriangleMesh::unit_cube() {
    static const auto cube = [] {
        TriangleSoup soup;
        for (int i = 0; i < 8; ++i) {
            soup.positions.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
        }
        for (const auto& [a, b, c, d] :
             std::array<std::array<std::uint32_t, 4>, 6>{{{0, 4, 6, 2},
                                                          {1, 3, 7, 5},
                                                          {0, 1, 5, 4},
                                                          {2, 6, 7, 3},
                                                          {0, 2, 3, 1},
                                                          {4, 5, 7, 6}}}) {
            soup.triangles.push_back({a, b, c});
            soup.triangles.push_back({a, c, d});
        }
        return std::make_shared<const TriangleMesh>(std::move(soup));
    }();
    return cube;
}

}  // namespace meniscus::geom
