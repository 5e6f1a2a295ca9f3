#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/inspect/scenes.hpp"

using namespace meniscus;
using namespace meniscus::test;
using inspect::Finding;

namespace {

geom::TriangleSoup cube(double half = 1.0, bool inside_out = false) {
    geom::TriangleSoup soup;
    for (int i = 0; i < 8; ++i) {
        soup.positions.push_back(half *
                                 Vec3{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    }
    soup.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    if (inside_out != geom::TriangleMesh(soup).stats().was_inside_out) {
        for (auto& triangle : soup.triangles) std::swap(triangle[1], triangle[2]);
    }
    return soup;
}

/// The cube, and another one moved.
geom::TriangleSoup two_shells(const geom::TriangleSoup& other, const Vec3& offset) {
    auto soup = cube();
    for (const auto& [i, j, k] : other.triangles) soup.triangles.push_back({i + 8, j + 8, k + 8});
    for (const auto& p : other.positions) soup.positions.push_back(p + offset);
    return soup;
}

geom::Mesh mesh(geom::TriangleSoup soup) {
    return {std::make_shared<const geom::TriangleMesh>(std::move(soup))};
}

std::vector<Finding> check_mesh(geom::TriangleSoup soup) {
    soup.is_numbered = true;
    scene::Scene scene;
    scene.camera.location = {0.0, 0.0, -9.0};
    add_medium(scene, "Cube", mesh(std::move(soup)), 1.5, 1.0);
    return inspect::check(tracer::compile(scene));
}

}  // namespace

TEST_CASE("a closed, consistent mesh is fine", "[inspect]") { CHECK(check_mesh(cube()).empty()); }

TEST_CASE("a mesh with a hole and an ior is found, with the hole's place", "[inspect]") {
    auto soup = cube();
    soup.triangles.pop_back();
    const auto findings = check_mesh(soup);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "open-mesh");
    CHECK(findings[0].text.find("3 boundary edges, one from <") != std::string::npos);
    REQUIRE(findings[0].position);
    CHECK(findings[0].position->z == Approx(1.0));
}

TEST_CASE("an inside-out mesh is found", "[inspect]") {
    const auto findings = check_mesh(cube(1.0, true));
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "inside-out-mesh");
}

TEST_CASE("triangles wound against their neighbours are noted", "[inspect]") {
    auto soup = cube();
    std::swap(soup.triangles[3][0], soup.triangles[3][1]);
    const auto findings = check_mesh(soup);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "inconsistent-mesh");
    CHECK_FALSE(inspect::has_warnings(findings));
}

TEST_CASE("a mesh that cuts through itself is found, with the place", "[inspect]") {
    auto soup = cube();
    soup.positions[7] = {-2.0, 0.9, -0.9};  // one corner is pulled through the opposite side
    const auto findings = check_mesh(soup);
    const auto found = std::ranges::find(findings, "self-intersecting-mesh", &Finding::lint);
    REQUIRE(found != findings.end());
    REQUIRE(found->position);
    REQUIRE(found->depth);
    CHECK(found->position->x == Approx(-1.0));  // the side that is pierced
    CHECK(*found->depth > 0.0);
    CHECK(*found->depth <= 1.0);
    // It names the two triangles, by their place in the soup and by their corners.
    REQUIRE(found->triangles.size() == 2);
    for (const std::uint32_t number : found->triangles) {
        const std::string name = "triangle " + std::to_string(number);
        CHECK(found->text.find(name + " <") != std::string::npos);
        for (const std::uint32_t corner : soup.triangles[number])
            CHECK(found->text.find(inspect::text(soup.positions[corner])) != std::string::npos);
    }
    CHECK(inspect::has_warnings(findings));
}

TEST_CASE("a mesh that is folded, but not through itself, is fine", "[inspect]") {
    auto soup = cube();
    soup.positions[7] = {-0.9, -0.9, -0.9};  // dented, almost to the opposite corner
    CHECK(check_mesh(soup).empty());
}

TEST_CASE("a shell that is in the mesh twice is a note", "[inspect]") {
    const auto findings = check_mesh(two_shells(cube(), Vec3{0.0}));
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "repeated-triangles");
    CHECK(findings[0].text.find("12 pairs of triangles") != std::string::npos);
    CHECK_FALSE(inspect::has_warnings(findings));
    CHECK(findings[0].triangles.size() == 2);
    // No copy, but a shell that shares a face with the other, back to back.
    CHECK(check_mesh(two_shells(cube(), {2.0, 0.0, 0.0})).empty());
}

TEST_CASE("a gap between shells of a mesh that is too thin to be meant is found", "[inspect]") {
    const auto findings = check_mesh(two_shells(cube(), {2.0 + 1e-9, 0.0, 0.0}));
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "thin-gap");
    CHECK(inspect::has_warnings(findings));
    REQUIRE(findings[0].depth);
    CHECK(*findings[0].depth == Approx(1e-9).epsilon(1e-6));
    REQUIRE(findings[0].position);
    CHECK(findings[0].position->x == Approx(1.0));
    CHECK(check_mesh(two_shells(cube(), {2.0 + 1e-4, 0.0, 0.0})).empty());
    CHECK(check_mesh(two_shells(cube(), {2.0 + 1e-15, 0.0, 0.0})).empty());  // as good as touching
}

TEST_CASE("two shells that overlap are a union: a note, with the place", "[inspect]") {
    const auto findings = check_mesh(two_shells(cube(), {1.5, 1.5, 1.5}));
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "nested-shells");
    CHECK_FALSE(inspect::has_warnings(findings));
    REQUIRE(findings[0].position);
    for (int axis = 0; axis < 3; ++axis) {
        CHECK((*findings[0].position)[axis] >= 0.5);
        CHECK((*findings[0].position)[axis] <= 1.0);
    }
    CHECK(findings[0].triangles.size() == 2);
}

TEST_CASE("triangles without area are noted", "[inspect]") {
    auto soup = cube();
    soup.triangles.push_back({0, 1, 1});
    const auto findings = check_mesh(soup);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "degenerate-triangles");
    CHECK_FALSE(inspect::has_warnings(findings));
    CHECK(findings[0].triangles == std::vector<std::uint32_t>{12});
    REQUIRE(findings[0].position);
    CHECK(*findings[0].position == Vec3{-1, -1, -1});
}

TEST_CASE("a shell within a shell is noted where it is no cavity", "[inspect]") {
    const auto with_inner = [](bool cavity) {
        return check_mesh(two_shells(cube(0.5, cavity), Vec3{0.0}));
    };
    const auto findings = with_inner(false);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].lint == "nested-shells");
    CHECK_FALSE(inspect::has_warnings(findings));
    CHECK(with_inner(true).empty());
}
