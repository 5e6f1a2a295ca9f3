#include "tests/geom/meshes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace meniscus::geom {

TriangleSoup icosphere(int levels, double radius, const Vec3& center) {
    const double g = std::numbers::phi;
    TriangleSoup soup;
    soup.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    soup.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (Vec3& p : soup.positions) p = glm::normalize(p);
    for (int level = 0; level < levels; ++level) {
        std::vector<TriangleIndices> finer;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            soup.positions.push_back(glm::normalize(soup.positions[a] + soup.positions[b]));
            return static_cast<std::uint32_t>(soup.positions.size() - 1);
        };
        for (const auto& [a, b, c] : soup.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        soup.triangles = std::move(finer);
    }
    for (Vec3& p : soup.positions) p = center + radius * p;
    return soup;
}

TriangleSoup gridded_box(int n, const Vec3& low, const Vec3& high) {
    TriangleSoup soup;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool upper : {false, true}) {
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int du, int dv) {
                        Vec3 w{0.0};
                        w[axis] = upper ? 1.0 : 0.0;
                        w[(axis + 1) % 3] = (i + du) / static_cast<double>(n);
                        w[(axis + 2) % 3] = (j + dv) / static_cast<double>(n);
                        soup.positions.push_back(low + w * (high - low));
                        return static_cast<std::uint32_t>(soup.positions.size() - 1);
                    };
                    const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                                        d = corner(0, 1);
                    if (upper) {
                        soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
                    } else {
                        soup.triangles.insert(soup.triangles.end(), {{a, c, b}, {a, d, c}});
                    }
                }
            }
        }
    }
    return soup;
}

TriangleSoup torus_mesh(int around, int across, double major, double minor) {
    TriangleSoup soup;
    const auto vertex = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % around) * across + j % across);
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double a = 2.0 * std::numbers::pi * i / around;
            const double b = 2.0 * std::numbers::pi * j / across;
            const double radius = major + minor * std::cos(b);
            soup.positions.push_back(
                {radius * std::cos(a), minor * std::sin(b), radius * std::sin(a)});
            soup.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
            soup.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
        }
    }
    return soup;
}

TriangleSoup joined(TriangleSoup a, const TriangleSoup& b) {
    const auto offset = static_cast<std::uint32_t>(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& [i, j, k] : b.triangles) {
        a.triangles.push_back({i + offset, j + offset, k + offset});
    }
    return a;
}

TriangleSoup turned_inside_out(TriangleSoup soup) {
    for (TriangleIndices& triangle : soup.triangles) std::swap(triangle[1], triangle[2]);
    return soup;
}

}  // namespace meniscus::geom
