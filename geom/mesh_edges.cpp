#include "geom/mesh_edges.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace meniscus::geom {

std::vector<EdgeUse> edge_uses(std::span<const TriangleIndices> triangles, std::size_t vertices) {
    // Counted into place by their lower vertex; the few at each are then sorted by the other one.
    const auto for_each_side = [&](auto&& visit) {
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t from = triangles[i][k], to = triangles[i][(k + 1) % 3];
                visit(EdgeUse{std::min(from, to), std::max(from, to), i, from < to});
            }
        }
    };
    std::vector<std::uint32_t> end(vertices + 1, 0);
    for_each_side([&](const EdgeUse& use) { ++end[use.low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<EdgeUse> uses(3 * triangles.size());
    for_each_side([&](const EdgeUse& use) { uses[end[use.low]++] = use; });
    tbb::parallel_for(std::size_t{0}, vertices, [&](std::size_t vertex) {
        const auto begin = uses.begin() + (vertex == 0 ? 0 : end[vertex - 1]);
        std::sort(begin, uses.begin() + end[vertex], [](const EdgeUse& a, const EdgeUse& b) {
            return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
        });
    });
    return uses;
}

int imbalance(std::span<const EdgeUse> edge) {
    int sum = 0;
    for (const EdgeUse& use : edge) sum += use.forward ? 1 : -1;
    return sum;
}

MeshParts connected_parts(std::size_t triangles, std::span<const EdgeUse> uses) {
    std::vector<std::uint32_t> parent(triangles);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
        for (const EdgeUse& use : edge) {
            const std::uint32_t a = root(edge[0].triangle), b = root(use.triangle);
            parent[std::max(a, b)] = std::min(a, b);
        }
    });
    MeshParts parts{std::vector<std::uint32_t>(triangles), 0};
    for (std::uint32_t i = 0; i < triangles; ++i) {
        // A root comes before all of its part.
        parts.of[i] = root(i) == i ? static_cast<std::uint32_t>(parts.count++) : parts.of[root(i)];
    }
    return parts;
}

AgreedParts agree_on_winding(std::size_t triangles, std::span<const EdgeUse> uses) {
    constexpr std::uint32_t none = 0xffffffff;
    struct Neighbour {
        std::uint32_t triangle = none;
        bool agrees = true;
    };
    std::vector<std::array<Neighbour, 3>> neighbours(triangles);
    const auto add = [&](std::uint32_t from, Neighbour to) {
        for (Neighbour& slot : neighbours[from]) {
            if (slot.triangle == none) {
                slot = to;
                return;
            }
        }
    };
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
        if (edge.size() != 2) return;
        const bool agree = edge[0].forward != edge[1].forward;
        add(edge[0].triangle, {edge[1].triangle, agree});
        add(edge[1].triangle, {edge[0].triangle, agree});
    });

    AgreedParts parts;
    parts.of.assign(triangles, none);
    parts.flipped.assign(triangles, false);
    std::vector<std::uint32_t> members;
    for (std::uint32_t seed = 0; seed < triangles; ++seed) {
        if (parts.of[seed] != none) continue;
        const auto part = static_cast<std::uint32_t>(parts.count++);
        members.assign(1, seed);
        parts.of[seed] = part;
        std::size_t flips = 0;
        for (std::size_t next = 0; next < members.size(); ++next) {
            const std::uint32_t triangle = members[next];
            for (const auto& [other, agrees] : neighbours[triangle]) {
                if (other == none || parts.of[other] != none) continue;
                parts.of[other] = part;
                parts.flipped[other] = parts.flipped[triangle] == agrees;
                flips += parts.flipped[other];
                members.push_back(other);
            }
        }
        if (2 * flips > members.size()) {
            for (const std::uint32_t member : members) parts.flipped[member].flip();
        }
    }
    return parts;
}

}  // namespace meniscus::geom
