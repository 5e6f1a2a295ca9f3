#include "inspect/self_intersection.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

// Meshes whose answer is known by how they are made.

using namespace meniscus;
using geom::TriangleIndices;
using geom::TriangleSoup;
using geom::Vec3;
using inspect::SelfIntersections;

namespace {

TriangleSoup operator+(TriangleSoup a, const TriangleSoup& b) {
    const auto offset = std::uint32_t(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& [i, j, k] : b.triangles)
        a.triangles.push_back({i + offset, j + offset, k + offset});
    return a;
}

/// Triangles about one edge, or any others, by their corners.
TriangleSoup sheet(const std::vector<std::array<Vec3, 3>>& triangles) {
    TriangleSoup soup;
    for (const auto& corners : triangles) {
        const auto first = std::uint32_t(soup.positions.size());
        soup.positions.insert(soup.positions.end(), corners.begin(), corners.end());
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

TriangleSoup box(const Vec3& low, const Vec3& high, bool cavity = false) {
    TriangleSoup soup;
    for (int i = 0; i < 8; ++i) {
        soup.positions.push_back(
            {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    }
    soup.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    if (cavity) {
        for (TriangleIndices& triangle : soup.triangles) std::swap(triangle[1], triangle[2]);
    }
    return soup;
}

/// A square in z = 0 around the origin, which is a corner of all its four triangles.
TriangleSoup floor() {
    const Vec3 o{0, 0, 0}, a{-1, -1, 0}, b{1, -1, 0}, c{1, 1, 0}, d{-1, 1, 0};
    return sheet({{o, a, b}, {o, b, c}, {o, c, d}, {o, d, a}});
}

/// A closed tube about the curve that `path` goes through once, in the plane y = 0: 2 * around *
/// across triangles.
TriangleSoup tube(auto&& path, double radius, int around, int across) {
    TriangleSoup soup;
    const auto at = [&](int i, int j) { return std::uint32_t((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        const double part = double(i) / around;
        const Vec3 p = path(part), along = path(part + 1e-4) - path(part - 1e-4);
        const Vec3 up{0, 1, 0}, side = glm::normalize(glm::cross(along, up));
        for (int j = 0; j < across; ++j) {
            const double turn = 2.0 * std::numbers::pi * j / across;
            soup.positions.push_back(p + radius * (std::cos(turn) * side + std::sin(turn) * up));
            soup.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    return soup;
}
Vec3 circle(double part) {
    const double angle = 2.0 * std::numbers::pi * part;
    return {std::cos(angle), 0.0, std::sin(angle)};
}
/// An eight that crosses itself at the origin, at right angles.
Vec3 eight(double part) {
    const double angle = 2.0 * std::numbers::pi * part;
    return {std::cos(angle), 0.0, std::sin(angle) * std::cos(angle)};
}

SelfIntersections found_in(TriangleSoup soup) {
    return inspect::self_intersections(geom::TriangleMesh(std::move(soup)));
}

/// Of any two shells, or of one.
std::size_t cuts(const SelfIntersections& found) {
    std::size_t sum = 0;
    for (const auto* pairs : {&found.cuts, &found.unions, &found.pierced})
        sum += *pairs ? (*pairs)->count : 0;
    return sum;
}
std::size_t cuts(TriangleSoup soup) { return cuts(found_in(std::move(soup))); }

bool is_clean(const SelfIntersections& found) {
    return cuts(found) == 0 && !found.overlaps && !found.folds && !found.repeated;
}

}  // namespace

TEST_CASE("a triangle through a triangle is a cut", "[inspect]") {
    const auto needle = [](double tip) {
        const Vec3 a{0.3, 0.1, 1}, b{0.35, 0.1, 1}, c{0.32, 0.12, tip};
        return sheet({{a, b, c}});
    };
    const auto found = found_in(floor() + needle(-0.25));
    CHECK(cuts(found) == 1);
    const auto& pairs = found.unions ? *found.unions : *found.pierced;
    CHECK(std::abs(pairs.position.z) < 1e-15);
    CHECK(pairs.depth == Approx(0.25));
    CHECK(cuts(floor() + needle(-1e-9)) == 1);
    CHECK(cuts(floor() + needle(0.0)) == 0);  // its tip touches
    CHECK(cuts(floor() + needle(1e-9)) == 0);
}

TEST_CASE("a cut along edges and through a corner is found", "[inspect]") {
    // A wall over the floor's diagonal: it cuts it along edges of the floor only, and its own
    // diagonal goes through the floor's corner.
    const auto wall = [](double bottom) {
        const Vec3 a{-0.5, -0.5, bottom}, b{0.5, 0.5, bottom}, c{0.5, 0.5, 1}, d{-0.5, -0.5, 1};
        return sheet({{a, b, c}, {a, c, d}});
    };
    const auto found = found_in(floor() + wall(-1.0));
    CHECK(cuts(found) == 4);  // each of its triangles with two of the floor's
    const auto& pairs = found.unions ? *found.unions : *found.pierced;
    CHECK(pairs.position.z == 0.0);
    CHECK(pairs.position.x == pairs.position.y);
    CHECK(pairs.depth == Approx(std::sqrt(2.0)));  // the floor's corners on either side
    CHECK(cuts(floor() + wall(0.0)) == 0);         // it stands on the floor
}

TEST_CASE("a cut along edges of both surfaces is found", "[inspect]") {
    const Vec3 left{-1, 0, 0}, right{1, 0, 0}, l{-0.5, 0, 0}, r{0.75, 0, 0};
    const auto about = [](const Vec3& from, const Vec3& to, const Vec3& one, const Vec3& other) {
        return sheet({{from, to, one}, {to, from, other}});
    };
    const auto roof = about(left, right, {0, 1, 0.5}, {0, -1, -0.5});
    const auto crossing = about(l, r, {0, 0.5, -1}, {0, -0.5, 1});
    CHECK(cuts(roof + crossing) == 4);
    const auto touching = about(l, r, {0, -0.5, 1}, {0, -1, 0.5});
    CHECK(cuts(roof + touching) == 0);
}

TEST_CASE("sheets that lie on each other are found by their facing", "[inspect]") {
    // A strip in one plane that is folded back and forth: 0 to 3, back to 2, and on to 5.
    const auto strip = [](const std::vector<double>& x) {
        std::vector<std::array<Vec3, 3>> triangles;
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            const Vec3 a{x[i], 0, 0}, b{x[i + 1], 0, 0}, c{x[i + 1], 1, 0}, d{x[i], 1, 0};
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
        return sheet(triangles);
    };
    CHECK(is_clean(found_in(strip({0, 3, 5}))));
    const auto once = found_in(strip({0, 3, 2}));
    CHECK(once.folds);
    CHECK_FALSE(once.overlaps);
    CHECK(cuts(once) == 0);
    const auto twice = found_in(strip({0, 3, 2, 5}));
    REQUIRE(twice.overlaps);
    CHECK(twice.overlaps->position.x >= 2.0);
    CHECK(twice.overlaps->position.x <= 3.0);
    CHECK(twice.overlaps->depth > 0.0);
    CHECK(twice.overlaps->depth < 1.0);
}

TEST_CASE("boxes of one mesh may touch, overlap and nest", "[inspect]") {
    const auto first = box({0, 0, 0}, {1, 1, 1});
    for (const auto& [low, high] :
         std::vector<std::pair<Vec3, Vec3>>{{{1, 0, 0}, {2, 1, 1}},        // a common face
                                            {{1, 0.25, 0.25}, {2, 2, 2}},  // a part of a face
                                            {{1, 1, 0}, {2, 2, 1}},        // a common edge
                                            {{1, 1, 0.5}, {2, 2, 3}},      // a part of an edge
                                            {{1, 1, 1}, {2, 2, 2}},        // a corner
                                            {{0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}}}) {
        CHECK(is_clean(found_in(first + box(low, high))));
        CHECK(is_clean(found_in(first + box(low, high, true))));
    }
    const auto overlapping = found_in(first + box({0.5, 0.5, 0.5}, {2, 2, 2}));
    REQUIRE(overlapping.unions);
    CHECK(overlapping.unions->depth == Approx(0.5));
    CHECK_FALSE(overlapping.cuts);
    CHECK_FALSE(overlapping.pierced);
    // As high as each other, so that their tops lie in one plane.
    CHECK(found_in(first + box({0.5, 0, 0.5}, {2, 1, 2})).unions);
    // A cavity that sticks out is one still, or was turned round with a warning of its own.
    const geom::TriangleMesh mesh(first + box({0.5, 0.25, 0.25}, {1.25, 0.5, 0.5}, true));
    const auto pierced = inspect::self_intersections(mesh);
    const auto& pairs = mesh.stats().was_inside_out ? pierced.unions : pierced.pierced;
    REQUIRE(pairs);
    CHECK(pairs->depth == Approx(0.25));
}

TEST_CASE("a tube that crosses itself is found where it does", "[inspect]") {
    CHECK(is_clean(found_in(tube(circle, 0.75, 48, 36))));
    const auto found = found_in(tube(eight, 0.1, 200, 24));
    REQUIRE(found.cuts);
    CHECK_FALSE(found.unions);
    CHECK(found.cuts->count >= 24);
    // Two cylinders of that radius at right angles share nothing farther away than that.
    CHECK(glm::length(found.cuts->position) < 0.1 * std::sqrt(3.0));
}

TEST_CASE("a fine mesh that is right has no finding, wherever it is", "[inspect]") {
    auto soup = tube(circle, 0.3, 256, 160);
    CHECK(is_clean(found_in(soup)));
    for (Vec3& p : soup.positions) p = 0.001 * p + Vec3{148376, 1234, -223423};
    CHECK(is_clean(found_in(soup)));
}
