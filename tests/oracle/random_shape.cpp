#include "tests/oracle/random_shape.hpp"

#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace meniscus::oracle {
namespace {

/// A tumbler, a turned stack, a ring, or a bowl of splines.
geom::Lathe random_lathe(Random& random) {
    const double h = random.lattice(0.5, 1.5), r = random.lattice(1.0, 1.5);
    const double s = random.lattice(0.5, 1.0);
    switch (random.below(6)) {
        case 0:
            return geom::Lathe(
                geom::Spline::linear,
                {{0.0, -h}, {r, -h}, {r, h}, {r - 0.5, h}, {r - 0.5, 0.5 - h}, {0.0, 0.5 - h}});
        case 1:
            return geom::Lathe(geom::Spline::linear, {{0.0, -h}, {s, -h}, {r, 0.0}, {0.0, h}});
        case 2:
            return geom::Lathe(geom::Spline::linear,
                               {{s, -h}, {s + 0.5, -h}, {s + 0.5, h}, {s, h}, {s, -h}});
        case 3:
            return geom::Lathe(geom::Spline::bezier, {{0.0, -h}, {r, -h}, {r, h}, {0.0, h}});
        case 4:
            // With h = 0.5 and r = s two neighbours are equal: a loop.
            return geom::Lathe(
                geom::Spline::cubic,
                {{0.0, -h - 0.5}, {0.0, -h}, {r, 0.5 - h}, {s, h - 0.5}, {0.0, h}, {0.0, h + 0.5}});
        default:
            return geom::Lathe(geom::Spline::quadratic,
                               {{0.0, -h - 0.5}, {0.0, -h}, {r, 0.0}, {s, h}, {0.0, h}});
    }
}

geom::Mesh random_mesh(Random& random) {
    const geom::Vec3 half = random.lattice_point(0.5, 1.5);
    switch (random.below(4)) {
        case 0:
        case 1:
            return box_mesh(-half, half);
        case 2:
            return octahedron(half);
        default:
            return ball_mesh(half.x, 1);
    }
}

}  // namespace

geom::Mesh mesh_of(std::vector<geom::Vec3> positions,
                   std::vector<geom::TriangleIndices> triangles) {
    geom::TriangleSoup soup;
    soup.positions = std::move(positions);
    soup.triangles = std::move(triangles);
    return {std::make_shared<const geom::TriangleMesh>(std::move(soup))};
}

geom::Mesh box_mesh(const geom::Vec3& low, const geom::Vec3& high) {
    std::vector<geom::Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    }
    return mesh_of(std::move(corners), {{0, 4, 6},
                                        {0, 6, 2},
                                        {1, 3, 7},
                                        {1, 7, 5},
                                        {0, 1, 5},
                                        {0, 5, 4},
                                        {2, 6, 7},
                                        {2, 7, 3},
                                        {0, 2, 3},
                                        {0, 3, 1},
                                        {4, 5, 7},
                                        {4, 7, 6}});
}

geom::Mesh octahedron(const geom::Vec3& half) {
    std::vector<geom::Vec3> corners;
    for (int axis = 0; axis < 3; ++axis) {
        corners.push_back(Random::along(axis, half[axis]));
        corners.push_back(Random::along(axis, -half[axis]));
    }
    std::vector<geom::TriangleIndices> triangles;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::uint32_t x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2 & 1);
        const bool even = ((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 == 0;
        triangles.push_back(even ? geom::TriangleIndices{x, y, z} : geom::TriangleIndices{x, z, y});
    }
    return mesh_of(std::move(corners), std::move(triangles));
}

geom::Mesh ball_mesh(double radius, int levels) {
    const geom::Mesh start = octahedron(geom::Vec3{radius});
    std::vector<geom::Vec3> positions;
    std::vector<geom::TriangleIndices> triangles;
    for (std::size_t i = 0; i < start.triangles->size(); ++i) {
        const auto base = std::uint32_t(positions.size());
        for (const geom::Vec3& corner : start.triangles->corners(geom::Face(i)))
            positions.push_back(corner);
        triangles.push_back({base, base + 1, base + 2});
    }
    for (int level = 0; level < levels; ++level) {
        std::vector<geom::TriangleIndices> finer;
        for (const auto& [a, b, c] : triangles) {
            // A middle's coordinates do not depend on the order of its ends: the mesh welds.
            const auto middle = [&](std::uint32_t i, std::uint32_t j) {
                positions.push_back(radius * glm::normalize(positions[i] + positions[j]));
                return std::uint32_t(positions.size() - 1);
            };
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.push_back({a, ab, ca});
            finer.push_back({ab, b, bc});
            finer.push_back({ca, bc, c});
            finer.push_back({ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    return mesh_of(std::move(positions), std::move(triangles));
}

RandomShape random_shape(Random& random, const RandomSceneOptions& options,
                         const geom::Vec3& center) {
    if (options.lathes && random.chance(0.25)) return {random_lathe(random), true};
    if (options.meshes && random.chance(0.3)) return {random_mesh(random), true};
    for (;;) {
        switch (random.below(10)) {
            case 0:
            case 1:
            case 2:
                return {geom::Sphere{center, random.lattice(0.5, 1.5)}};
            case 3:
            case 4:
            case 5: {
                const geom::Vec3 half = random.lattice_point(0.5, 1.5);
                return {geom::Box{center - half, center + half}};
            }
            case 6:
            case 7: {
                const geom::Vec3 half = Random::along(random.below(3), random.lattice(0.5, 1.5));
                return {
                    geom::Cylinder{center - half, center + half, random.lattice(0.5, 1.5), false}};
            }
            case 8: {
                if (!options.cones) break;
                const geom::Vec3 half = Random::along(random.below(3), random.lattice(0.5, 1.5));
                const double base = random.lattice(0.5, 1.5), cap = random.lattice(0.0, 1.0);
                if (base == cap) break;
                return {geom::Cone{center - half, base, center + half, cap, false}};
            }
            default:
                if (!options.tori) break;
                return {geom::Torus{random.lattice(1.0, 1.5), 0.5}, true};
        }
    }
}

}  // namespace meniscus::oracle
