#include "geom/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "geom/cylindrical.hpp"
#include "geom/mesh_edges.hpp"
#include "geom/triangle.hpp"
#include "geom/watertight.hpp"

namespace meniscus::geom {

namespace {

struct HashPosition {
    std::size_t operator()(const Vec3& p) const {
        std::size_t hash = 0;
        for (int i = 0; i < 3; ++i) {
            hash = (hash ^ std::hash<double>{}(p[i])) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

bool is_finite(const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

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

}  // namespace

TriangleMesh::TriangleMesh(TriangleSoup soup) {
    weld(soup);
    build_hierarchy();
    orient();
    for (std::size_t i = 0; i < triangles_.size(); ++i) stats_.volume += volume_under(i);
    stats_.triangles = triangles_.size();
    stats_.vertices = positions_.size();
}

void TriangleMesh::weld(TriangleSoup& soup) {
    const bool smooth = !soup.corner_normals.empty();
    if (smooth && soup.corner_normals.size() != soup.triangles.size()) {
        throw std::invalid_argument(
            "a mesh must have normals for all of its triangles or for none");
    }
    std::unordered_map<Vec3, std::uint32_t, HashPosition> known;
    known.reserve(soup.positions.size());
    constexpr std::uint32_t unused = 0xffffffff;
    std::vector<std::uint32_t> new_index(soup.positions.size(), unused);
    const auto welded = [&](std::uint32_t old) {
        if (old >= soup.positions.size()) {
            throw std::invalid_argument("a triangle of a mesh uses vertex " + std::to_string(old) +
                                        ", but there are only " +
                                        std::to_string(soup.positions.size()));
        }
        if (new_index[old] != unused) return new_index[old];
        const Vec3 p = soup.positions[old] + Vec3{0.0};  // makes -0 and 0 the same
        if (!is_finite(p)) throw std::invalid_argument("a vertex of a mesh is not finite");
        const auto [entry, is_new] =
            known.try_emplace(p, static_cast<std::uint32_t>(positions_.size()));
        if (is_new) {
            positions_.push_back(p);
        } else {
            ++stats_.duplicate_positions;
        }
        return new_index[old] = entry->second;
    };

    triangles_.reserve(soup.triangles.size());
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        TriangleIndices triangle = soup.triangles[i];
        for (std::uint32_t& corner : triangle) corner = welded(corner);
        const auto [a, b, c] = triangle;
        // One whose corners differ but lie on a line stays: it may join its neighbours.
        if (a == b || b == c || c == a) {
            ++stats_.degenerate;
            continue;
        }
        triangles_.push_back(triangle);
        if (!smooth) continue;
        for (const std::uint32_t n : soup.corner_normals[i]) {
            if (n >= soup.normals.size() && n != TriangleSoup::no_normal) {
                throw std::invalid_argument("a triangle of a mesh uses normal " +
                                            std::to_string(n) + ", but there are only " +
                                            std::to_string(soup.normals.size()));
            }
        }
        corner_normals_.push_back(soup.corner_normals[i]);
    }
    if (triangles_.empty()) throw std::invalid_argument("a mesh has no triangle with an area");
    normals_ = std::move(soup.normals);
    positions_.shrink_to_fit();
}

void TriangleMesh::build_hierarchy() {
    std::vector<Bounds> boxes(triangles_.size());
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        for (const std::uint32_t corner : triangles_[i]) boxes[i].extend(positions_[corner]);
        bounds_.extend(boxes[i]);
    }
    magnitude_ = std::max(max_abs(bounds_.low), max_abs(bounds_.high));
    bvh_ = Bvh(boxes);
    const auto reorder = [&](std::vector<TriangleIndices>& list) {
        if (list.empty()) return;
        std::vector<TriangleIndices> sorted(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) sorted[i] = list[bvh_.order()[i]];
        list = std::move(sorted);
    };
    reorder(triangles_);
    reorder(corner_normals_);
    bvh_.renumber();

    // Vertices in the order of their first use: what a ray needs together lies together.
    constexpr std::uint32_t unused = 0xffffffff;
    std::vector<std::uint32_t> new_index(positions_.size(), unused);
    std::vector<Vec3> sorted;
    sorted.reserve(positions_.size());
    for (TriangleIndices& triangle : triangles_) {
        for (std::uint32_t& corner : triangle) {
            if (new_index[corner] == unused) {
                new_index[corner] = static_cast<std::uint32_t>(sorted.size());
                sorted.push_back(positions_[corner]);
            }
            corner = new_index[corner];
        }
    }
    sorted.shrink_to_fit();
    positions_ = std::move(sorted);
}

void TriangleMesh::orient() {
    std::vector<EdgeUse> uses = edge_uses(triangles_);
    const MeshParts connected = connected_parts(triangles_.size(), uses);
    stats_.components = connected.count;
    bool all_even = true;
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
        const bool even = edge.size() % 2 == 0;
        all_even &= even;
        stats_.was_consistent &= !even || imbalance(edge) == 0;
    });

    if (!stats_.was_consistent) {
        const AgreedParts agreed = agree_on_winding(triangles_.size(), uses);
        std::vector<TriangleIndices> given = triangles_;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (agreed.flipped[i]) flip(i);
        }
        if (all_even) orient_by_nesting(agreed.of, agreed.count);
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            stats_.flipped += given[i] != triangles_[i];
        uses = edge_uses(triangles_);
    }

    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
        if (imbalance(edge) == 0) return;
        ++stats_.open_edges;
        if (stats_.first_open_edges.size() < 8) {
            stats_.first_open_edges.push_back(
                {positions_[edge[0].low], positions_[edge[0].high], static_cast<int>(edge.size())});
        }
    });
    if (is_closed() && stats_.was_consistent) turn_shells_outward(connected.of, connected.count);
}

/// POV-Ray's rule: a line toggles between inside and outside, so the outer side of a part is where
/// an even number of surfaces is still to come.
void TriangleMesh::orient_by_nesting(const std::vector<std::uint32_t>& part_of, std::size_t parts) {
    std::vector<std::pair<double, std::uint32_t>> largest(parts, {-1.0, 0u});
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        const auto [a, b, c] = corners(static_cast<Face>(i));
        const double area = glm::length(glm::cross(b - a, c - a));
        largest[part_of[i]] = std::max(largest[part_of[i]], {area, i});
    }
    std::vector<bool> inward(parts);
    for (std::size_t part = 0; part < parts; ++part) {
        const auto face = static_cast<Face>(largest[part].second);
        const auto [a, b, c] = corners(face);
        bool odd = false;
        visit_hits(Ray{(a + b + c) / 3.0, normal(face)}, [&](const Crossing& hit) {
            if (hit.t > 0.0 && hit.face != face) odd = !odd;
        });
        inward[part] = odd;
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        if (inward[part_of[i]]) flip(i);
    }
}

/// The winding is consistent, so that shells count. But nothing can be inside less than not at all:
/// everything is flipped if the volume is negative, and then each shell that is inward and not the
/// wall of a cavity.
void TriangleMesh::turn_shells_outward(const std::vector<std::uint32_t>& part_of,
                                       std::size_t parts) {
    std::vector<double> volumes(parts, 0.0);
    std::vector<std::uint32_t> samples(parts);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        volumes[part_of[i]] += volume_under(i);
        samples[part_of[i]] = i;
    }
    const auto flip_all_of = [&](auto&& is_member) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (is_member(part_of[i])) flip(i);
        }
    };
    if (std::accumulate(volumes.begin(), volumes.end(), 0.0) < 0.0) {
        stats_.was_inside_out = true;
        flip_all_of([](std::uint32_t) { return true; });
        for (double& volume : volumes) volume = -volume;
    }
    std::vector<std::uint32_t> inward;
    for (std::uint32_t part = 0; part < parts; ++part) {
        if (volumes[part] < 0.0) inward.push_back(part);
    }
    // The outer ones first, for a shell's flip changes how deep those within it are.
    std::sort(inward.begin(), inward.end(),
              [&](auto a, auto b) { return volumes[a] < volumes[b]; });
    for (const std::uint32_t part : inward) {
        // How deep is the side that its normals look to?
        const auto face = static_cast<Face>(samples[part]);
        const auto [a, b, c] = corners(face);
        int depth = 0;
        visit_hits(Ray{(a + b + c) / 3.0, normal(face)}, [&](const Crossing& hit) {
            if (hit.t > 0.0 && hit.face != face) depth += hit.entering ? -1 : 1;
        });
        // A cavity is 0 deep or more; a shell that stands alone and inside-out would be less than 0
        // deep within.
        if (depth >= 0) continue;
        flip_all_of([&](std::uint32_t p) { return p == part; });
        stats_.was_inside_out = true;
    }
}

void TriangleMesh::flip(std::size_t triangle) {
    std::swap(triangles_[triangle][1], triangles_[triangle][2]);
    if (!corner_normals_.empty()) {
        std::swap(corner_normals_[triangle][1], corner_normals_[triangle][2]);
    }
}

/// Six times the volume of the cone from the mesh's middle is a determinant; the sum over a closed
/// mesh is its volume.
double TriangleMesh::volume_under(std::size_t triangle) const {
    const Vec3 middle = bounds_.center();
    const auto [a, b, c] = corners(static_cast<Face>(triangle));
    return glm::dot(a - middle, glm::cross(b - middle, c - middle)) / 6.0;
}

std::size_t TriangleMesh::memory_bytes() const {
    const auto bytes = [](const auto& list) { return list.size() * sizeof(list[0]); };
    return bytes(positions_) + bytes(triangles_) + bytes(normals_) + bytes(corner_normals_) +
           bvh_.memory_bytes();
}

std::array<Vec3, 3> TriangleMesh::corners(Face face) const {
    const auto [a, b, c] = triangles_[face];
    return {positions_[a], positions_[b], positions_[c]};
}

template <class Visit>
void TriangleMesh::visit_hits(const Ray& ray, Visit&& visit) const {
    const TriangleLine line(ray);
    bvh_.traverse_line(ray, [&](std::uint32_t i) {
        const auto [a, b, c] = corners(static_cast<Face>(i));
        if (const auto hit = line.hit(a, b, c)) {
            visit(Crossing{hit->t, static_cast<Face>(i), hit->entering});
        }
    });
}

void TriangleMesh::crossings(const Ray& ray, Crossings& out) const {
    const std::size_t begin = out.size();
    visit_hits(ray, [&](const Crossing& hit) { out.push_back(hit); });
    std::sort(out.begin() + begin, out.end(), [](const Crossing& a, const Crossing& b) {
        return a.t < b.t || (a.t == b.t && a.face < b.face);
    });
    if (!is_closed() || out.size() < begin + 2) return;
    const double furthest = std::max(std::fabs(out[begin].t), std::fabs(out.back().t));
    const double magnitude = max_abs(ray.origin) + furthest * max_abs(ray.direction) + magnitude_;
    take_turns(out, begin, 4096.0 * unit_roundoff * magnitude / glm::length(ray.direction));
}

int TriangleMesh::depth_at(const Vec3& p) const {
    if (!bounds_.contains(p)) return 0;
    int depth = 0;
    visit_hits(Ray{p, odd_direction}, [&](const Crossing& hit) {
        if (hit.t > 0.0) depth += hit.entering ? -1 : 1;
    });
    return depth;
}

Vec3 TriangleMesh::normal(Face face) const {
    const auto [a, b, c] = corners(face);
    const Vec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : any_perpendicular(b - a);
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
    return to_plane(point.from(positions_[triangles_[face][0]]), normal(face));
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
