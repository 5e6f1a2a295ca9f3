#include "geom/mesh_orientation.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

namespace meniscus::geom {

void TriangleMesh::Orientation::run() {
    MeshStats& stats = mesh_.stats_;
    std::vector<EdgeUse> uses = edge_uses(triangles_, positions_.size());
    const MeshParts connected = connected_parts(triangles_.size(), uses);
    stats.components = connected.count;
    bool all_even = true;
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
        const bool even = edge.size() % 2 == 0;
        all_even &= even;
        stats.was_consistent &= !even || imbalance(edge) == 0;
    });

    if (!stats.was_consistent) {
        const AgreedParts agreed = agree_on_winding(triangles_.size(), uses);
        std::vector<TriangleIndices> given = triangles_;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (agreed.flipped[i]) flip(i);
        }
        if (all_even) orient_by_nesting(agreed.of, agreed.count);
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            stats.flipped += given[i] != triangles_[i];
        uses = edge_uses(triangles_, positions_.size());
    }

    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
        if (imbalance(edge) == 0) return;
        ++stats.open_edges;
        if (stats.first_open_edges.size() < 8) {
            stats.first_open_edges.push_back(
                {positions_[edge[0].low], positions_[edge[0].high], static_cast<int>(edge.size())});
        }
    });
    if (mesh_.is_closed() && stats.was_consistent)
        turn_shells_outward(connected.of, connected.count);
    for (std::size_t i = 0; i < triangles_.size(); ++i) stats.volume += volume_under(i);
}

/// POV-Ray's rule: a line toggles between inside and outside, so the outer side of a part is where
/// an even number of surfaces is still to come.
void TriangleMesh::Orientation::orient_by_nesting(const std::vector<std::uint32_t>& part_of,
                                                  std::size_t parts) {
    std::vector<std::pair<double, std::uint32_t>> largest(parts, {-1.0, 0u});
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        const auto [a, b, c] = corners(i);
        const double area = glm::length(glm::cross(b - a, c - a));
        largest[part_of[i]] = std::max(largest[part_of[i]], {area, i});
    }
    std::vector<bool> inward(parts);
    for (std::size_t part = 0; part < parts; ++part) {
        inward[part] = ahead_of(largest[part].second).size() % 2 != 0;
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        if (inward[part_of[i]]) flip(i);
    }
}

/// The winding is consistent, so that shells count. But nothing can be inside less than not at all:
/// everything is flipped if the volume is negative, and then each shell that is inward and not the
/// wall of a cavity.
void TriangleMesh::Orientation::turn_shells_outward(const std::vector<std::uint32_t>& part_of,
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
        mesh_.stats_.was_inside_out = true;
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
        int depth = 0;
        for (const Crossing& hit : ahead_of(samples[part])) depth += hit.entering ? -1 : 1;
        // A cavity is 0 deep or more; a shell that stands alone and inside-out would be less than 0
        // deep within.
        if (depth >= 0) continue;
        flip_all_of([&](std::uint32_t p) { return p == part; });
        mesh_.stats_.was_inside_out = true;
    }
}

void TriangleMesh::Orientation::flip(std::size_t triangle) {
    std::swap(triangles_[triangle][1], triangles_[triangle][2]);
    mesh_.blocks_.flip(static_cast<Face>(triangle));
    if (!mesh_.corner_normals_.empty())
        std::swap(mesh_.corner_normals_[triangle][1], mesh_.corner_normals_[triangle][2]);
}

std::array<Vec3, 3> TriangleMesh::Orientation::corners(std::size_t triangle) const {
    const auto [a, b, c] = triangles_[triangle];
    return {positions_[a], positions_[b], positions_[c]};
}

/// Six times the volume of the cone from the mesh's middle is a determinant; the sum over a closed
/// mesh is its volume.
double TriangleMesh::Orientation::volume_under(std::size_t triangle) const {
    const Vec3 middle = mesh_.frame_.center;
    const auto [a, b, c] = corners(triangle);
    return glm::dot(a - middle, glm::cross(b - middle, c - middle)) / 6.0;
}

Crossings TriangleMesh::Orientation::ahead_of(std::size_t triangle) const {
    const auto face = static_cast<Face>(triangle);
    const auto [a, b, c] = corners(triangle);
    Crossings found;
    mesh_.crossings(Ray{(a + b + c) / 3.0, mesh_.normal(face)}, {.from = 0.0}, found);
    for (std::size_t i = found.size(); i-- > 0;) {
        if (found[i].face == face) found.erase(i);
    }
    return found;
}

}  // namespace meniscus::geom
