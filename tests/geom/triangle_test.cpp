#include "geom/triangle.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "geom/watertight.hpp"
#include "tests/geom/lines.hpp"

namespace meniscus::geom {

TEST_CASE("a line enters a triangle against its normal", "[geom]") {
    Crossings hits;
    Triangle{}.hits({{0.25, 0.25, 5.0}, {0.0, 0.0, -1.0}}, hits);
    REQUIRE(hits.size() == 1);
    CHECK(hits[0].t == 5.0);
    CHECK(hits[0].entering);
    CHECK(Triangle{}.normal(0, {}).z == 1.0);
}

TEST_CASE("of the triangles round a vertex every line through it meets exactly one", "[geom]") {
    Dice dice(6);
    for (int i = 0; i < 20000; ++i) {
        const int count = 3 + dice.below(6);
        const Vec3 hub{0.1, 0.2, 0.3};
        std::vector<Vec3> rim;
        for (int k = 0; k < count; ++k) {
            const double angle = 2.0 * 3.14159 * k / count;
            rim.push_back(hub + Vec3{std::cos(angle), std::sin(angle), dice.between(-0.2, 0.2)});
        }
        // Aimed at the vertex itself, or at a point on an edge from it.
        const Vec3 target = i % 2 == 0 ? hub : hub + dice.between(0.0, 1.0) * (rim[0] - hub);
        Vec3 d = i % 3 == 0 ? Vec3{0, 0, 1} : glm::normalize(Vec3{0, 0, 2} + dice.direction());
        const TriangleLine line({target - dice.between(0.0, 5.0) * d, d});
        int hits = 0;
        for (int k = 0; k < count; ++k)
            hits += line.hit(hub, rim[k], rim[(k + 1) % count]).has_value();
        REQUIRE(hits == 1);
    }
}

TEST_CASE("a smooth triangle shades with the mean of its normals", "[geom]") {
    Triangle triangle;
    triangle.smooth = true;
    triangle.na = {0, 0, 1};
    triangle.nb = {1, 0, 1};
    triangle.nc = {0, 1, 1};
    CHECK(glm::length(triangle.shading_normal(0, triangle.a) - Vec3{0, 0, 1}) < 1e-15);
    CHECK(glm::length(triangle.shading_normal(0, triangle.b) - glm::normalize(triangle.nb)) <
          1e-15);
    const Vec3 middle = (triangle.a + triangle.b + triangle.c) / 3.0;
    const Vec3 mean = glm::normalize(glm::normalize(triangle.na) + glm::normalize(triangle.nb) +
                                     glm::normalize(triangle.nc));
    CHECK(glm::length(triangle.shading_normal(0, middle) - mean) < 1e-15);
    CHECK(triangle.normal(0, middle) == Vec3{0, 0, 1});
}

}  // namespace meniscus::geom
