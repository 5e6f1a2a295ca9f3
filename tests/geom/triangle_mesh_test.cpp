#include "geom/triangle_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "geom/watertight.hpp"
#include "tests/geom/lines.hpp"
#include "tests/geom/meshes.hpp"

namespace meniscus::geom {

namespace {

int balance(const TriangleMesh& mesh, const Ray& ray) {
    Crossings found;
    mesh.crossings(ray, found);
    int sum = 0;
    for (const Crossing& crossing : found) sum += crossing.entering ? 1 : -1;
    return sum;
}

bool takes_turns(const TriangleMesh& mesh, const Ray& ray) {
    Crossings found;
    mesh.crossings(ray, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i].entering != (i % 2 == 0)) return false;
    }
    return found.size() % 2 == 0;
}

}  // namespace

TEST_CASE("every line enters a closed mesh as often as it leaves it", "[geom]") {
    const TriangleMesh meshes[] = {TriangleMesh(icosphere(1)),
                                   TriangleMesh(gridded_box(3, Vec3{-1.0}, {1.0, 0.5, 0.7})),
                                   TriangleMesh(torus_mesh(12, 8))};
    for (const TriangleMesh& mesh : meshes) {
        REQUIRE(mesh.is_closed());
        REQUIRE(mesh.stats().was_consistent);
        Dice dice(8);
        int unbalanced = 0, out_of_turn = 0;
        for (int i = 0; i < 40000; ++i) {
            const auto corners = mesh.corners(dice.below(static_cast<int>(mesh.size())));
            const double s = dice.between(0.0, 1.0);
            const Vec3 targets[] = {corners[0], corners[0] + s * (corners[1] - corners[0]),
                                    0.5 * (corners[0] + corners[1]), dice.point(1.0)};
            Vec3 d = dice.direction();
            if (i % 5 == 0) {
                d = Vec3{0.0};
                d[dice.below(3)] = 1.0;
            }
            // Now and then from a vertex to a vertex: along edges and diagonals.
            if (i % 7 == 0) {
                const Vec3 other = mesh.corners(dice.below(static_cast<int>(mesh.size())))[1];
                if (other != targets[0]) d = glm::normalize(other - targets[0]);
            }
            const Ray ray{targets[i % 4] - (i % 3) * 2.0 * d, d};
            unbalanced += balance(mesh, ray) != 0;
            out_of_turn += !takes_turns(mesh, ray);
        }
        CHECK(unbalanced == 0);
        CHECK(out_of_turn == 0);
    }
}

TEST_CASE("a mesh finds what testing every triangle finds", "[geom]") {
    const TriangleMesh mesh(icosphere(3));
    for (const Ray& ray : awkward_lines(2000)) {
        Crossings found;
        mesh.crossings(ray, found);
        const TriangleLine line(ray);
        std::vector<double> expected;
        for (std::size_t i = 0; i < mesh.size(); ++i) {
            const auto [a, b, c] = mesh.corners(static_cast<Face>(i));
            if (const auto hit = line.hit(a, b, c)) expected.push_back(hit->t);
        }
        std::sort(expected.begin(), expected.end());
        REQUIRE(found.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) REQUIRE(found[i].t == expected[i]);
    }
}

TEST_CASE("a mesh that is inside-out is turned round as a whole", "[geom]") {
    const TriangleMesh mesh(turned_inside_out(icosphere(2)));
    CHECK(mesh.is_closed());
    CHECK(mesh.stats().was_inside_out);
    CHECK(mesh.depth_at({0.1, 0.2, 0.3}) == 1);
    CHECK(mesh.stats().volume == Approx(4.05).epsilon(0.03));
}

TEST_CASE("shells wound alike count, and a cavity does not", "[geom]") {
    const Vec3 middle{0.03, 0.02, 0.01};
    const TriangleMesh nested(joined(icosphere(2), icosphere(1, 0.5)));
    CHECK(nested.depth_at(middle) == 2);
    CHECK(nested.stats().components == 2);
    const TriangleMesh hollow(joined(icosphere(2), turned_inside_out(icosphere(1, 0.5))));
    CHECK(hollow.depth_at(middle) == 0);
    CHECK(hollow.depth_at({0.0, 0.7, 0.1}) == 1);
    CHECK_FALSE(hollow.stats().was_inside_out);
    // Side by side, one of them inside-out: nothing can be less than outside.
    const TriangleMesh pair(
        joined(icosphere(2, 1.0), turned_inside_out(icosphere(1, 0.5, {3.0, 0.0, 0.0}))));
    CHECK(pair.depth_at({3.03, 0.02, 0.01}) == 1);
    CHECK(pair.stats().was_inside_out);
}

TEST_CASE("triangles wound at random are put in order, and nesting toggles", "[geom]") {
    TriangleSoup soup = joined(icosphere(2), icosphere(2, 0.5));
    Dice dice(10);
    for (TriangleIndices& triangle : soup.triangles) {
        if (dice.below(2) == 0) std::swap(triangle[0], triangle[1]);
    }
    const TriangleMesh mesh(soup);
    CHECK(mesh.is_closed());
    CHECK_FALSE(mesh.stats().was_consistent);
    CHECK(mesh.stats().flipped > 100);
    CHECK(mesh.depth_at({0.03, 0.02, 0.01}) == 0);
    CHECK(mesh.depth_at({0.0, 0.7, 0.1}) == 1);
    CHECK(mesh.depth_at({0.0, 1.7, 0.1}) == 0);
    for (const Ray& ray : awkward_lines(1000)) REQUIRE(balance(mesh, ray) == 0);
}

TEST_CASE("a hole is found and told", "[geom]") {
    TriangleSoup soup = gridded_box(2, Vec3{0.0}, Vec3{1.0});
    soup.triangles.pop_back();
    const TriangleMesh mesh(soup);
    CHECK_FALSE(mesh.is_closed());
    CHECK(mesh.stats().open_edges == 3);
    REQUIRE(mesh.stats().first_open_edges.size() == 3);
    CHECK(mesh.stats().first_open_edges[0].uses == 1);
    CHECK(mesh.stats().was_consistent);
}

TEST_CASE("equal positions are welded and triangles without an area dropped", "[geom]") {
    TriangleSoup soup;
    for (int copy = 0; copy < 2; ++copy) {
        for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}})
            soup.positions.push_back(p);
    }
    soup.triangles = {{0, 1, 2}, {3, 4, 0}, {5, 5, 1}};
    const TriangleMesh mesh(soup);
    CHECK(mesh.stats().triangles == 1);
    CHECK(mesh.stats().degenerate == 2);
    CHECK(mesh.stats().vertices == 3);
}

TEST_CASE("a mesh refuses what is no mesh", "[geom]") {
    TriangleSoup soup;
    CHECK_THROWS_WITH(TriangleMesh(soup), Catch::Contains("no triangle"));
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}};
    soup.triangles = {{0, 1, 2}};
    CHECK_THROWS_WITH(TriangleMesh(soup), Catch::Contains("not finite"));
    soup.triangles = {{0, 1, 7}};
    CHECK_THROWS_WITH(TriangleMesh(soup), Catch::Contains("vertex 7"));
}

TEST_CASE("a mesh of a hundred thousand triangles is frugal", "[geom]") {
    const TriangleMesh mesh(icosphere(6));
    CHECK(mesh.size() == 81920);
    CHECK(mesh.memory_bytes() < 105 * mesh.size());
}

}  // namespace meniscus::geom
