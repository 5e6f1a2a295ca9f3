#include "geom/cone.hpp"

#include <catch2/catch.hpp>

#include "geom/cylinder.hpp"
#include "geom/shape.hpp"
#include "tests/geom/lines.hpp"

namespace meniscus::geom {

TEST_CASE("a line across a cone is inside as far as the cone is wide there", "[geom]") {
    const Cone cone{{0.0, 0.0, 0.0}, 1.0, {0.0, 2.0, 0.0}, 0.0};
    const Interval interval = cone.interval({{-3.0, 1.0, 0.0}, {1.0, 0.0, 0.0}}, no_face);
    CHECK(interval.hit);
    CHECK(interval.t0 == Approx(2.5).epsilon(1e-15));
    CHECK(interval.t1 == Approx(3.5).epsilon(1e-15));
}

TEST_CASE("a cone has no second half beyond its point", "[geom]") {
    const Cone cone{{0.0, 0.0, 0.0}, 1.0, {0.0, 2.0, 0.0}, 0.0};
    CHECK_FALSE(cone.interval({{-3.0, 3.0, 0.0}, {1.0, 0.0, 0.0}}, no_face).hit);
    // Down through the point: enters there, leaves through the base.
    const Interval down = cone.interval({{0.0, 5.0, 0.0}, {0.0, -1.0, 0.0}}, no_face);
    CHECK(down.hit);
    CHECK(down.t0 == Approx(3.0));
    CHECK(down.t1 == 5.0);
    CHECK(down.face1 == Cone::base_face);
}

TEST_CASE("a line parallel to the slope of a cone meets its side once", "[geom]") {
    const Cone cone{{0.0, 0.0, 0.0}, 1.0, {0.0, 1.0, 0.0}, 0.0};
    const Vec3 d = glm::normalize(Vec3{-1.0, 1.0, 0.0});
    const Interval interval = cone.interval({{0.5, -0.5, 0.0}, d}, no_face);
    CHECK(interval.hit);
    CHECK(interval.face0 == Cone::base_face);
    CHECK(interval.face1 == Cone::side_face);
    const Vec3 p = Ray{{0.5, -0.5, 0.0}, d}.at(interval.t1);
    CHECK(p.y == Approx(0.5));
}

TEST_CASE("a line parallel to the slope of a cone misses it when it is outside", "[geom]") {
    const Cone cone{{2.0, -1.0, -2.0}, 0.5, {2.0, 1.0, -2.0}, 0.0};
    // Both ways along the same line, which stays 8e-10 outside up to the point of the cone.
    const Vec3 origin{2.4094166914409052, -5.0740177243081828, -3.4622700442755585};
    const Vec3 direction{-0.065392060059989335, 0.97014250014533188, 0.23355386507800605};
    CHECK_FALSE(cone.interval({origin, direction}, no_face).hit);
    CHECK_FALSE(cone.interval({origin, -direction}, no_face).hit);
    // As far inside, it enters by the base and leaves by the side next to the point.
    const Vec3 inside{origin.x - 1e-9, origin.y, origin.z + 1e-9};
    const Interval interval = cone.interval({inside, direction}, no_face);
    CHECK(interval.hit);
    CHECK(interval.face0 == Cone::base_face);
    CHECK(Ray{inside, direction}.at(interval.t1).y == Approx(1.0).margin(1e-6));
}

TEST_CASE("a cone of equal radii is a cylinder", "[geom]") {
    const Cone cone{{1.0, 0.0, 0.0}, 0.75, {0.5, 2.0, 0.25}, 0.75};
    const Cylinder cylinder{cone.base, cone.cap, 0.75};
    for (const Ray& ray : awkward_lines(4000)) {
        const Interval a = cone.interval(ray, no_face), b = cylinder.interval(ray, no_face);
        REQUIRE(a.hit == b.hit);
        if (a.hit && a.t1 - a.t0 > 1e-6) {
            REQUIRE(a.t0 == Approx(b.t0).margin(1e-9));
            REQUIRE(a.t1 == Approx(b.t1).margin(1e-9));
            REQUIRE(a.face0 == b.face0);
            REQUIRE(a.face1 == b.face1);
        }
    }
}

TEST_CASE("a frustum is the same from either end", "[geom]") {
    const Cone up{{0.0, -1.0, 0.0}, 1.0, {0.0, 1.0, 0.0}, 0.25};
    const Cone down{{0.0, 1.0, 0.0}, 0.25, {0.0, -1.0, 0.0}, 1.0};
    for (const Ray& ray : awkward_lines(4000)) {
        const Interval a = up.interval(ray, no_face), b = down.interval(ray, no_face);
        if (glm::max(a.t1 - a.t0, b.t1 - b.t0) < 1e-6) continue;
        // The base belongs to a cone and the cap does not, for lines that run within them.
        if (ray.direction.y == 0.0 && glm::abs(ray.origin.y) == 1.0) continue;
        REQUIRE(a.hit == b.hit);
        if (a.hit) REQUIRE(a.t0 == Approx(b.t0).margin(1e-9));
        if (a.hit) REQUIRE(a.t1 == Approx(b.t1).margin(1e-9));
    }
}

TEST_CASE("roots near the point of a cone are as good as elsewhere", "[geom]") {
    const Cone cone{{0.0, 0.0, 0.0}, 1.0, {0.0, 2.0, 0.0}, 0.0};
    Dice dice(5);
    for (int i = 0; i < 4000; ++i) {
        const Vec3 target = Vec3{0.0, 2.0, 0.0} + dice.point(1e-5);
        const Vec3 d = dice.direction();
        const Ray ray{target - 5.0 * d, d};
        const Interval interval = cone.interval(ray, no_face);
        if (!interval.hit || interval.face0 != Cone::side_face) continue;
        const Vec3 p = ray.at(interval.t0);
        REQUIRE(glm::length(on_face(cone, Cone::side_face, p) - p) < 32.0 * unit_roundoff * 12.0);
    }
}

}  // namespace meniscus::geom
