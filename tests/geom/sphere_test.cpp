#include "geom/sphere.hpp"

#include <catch2/catch.hpp>

#include "geom/shape.hpp"
#include "tests/geom/lines.hpp"

namespace meniscus::geom {

TEST_CASE("a line through the centre of a sphere is inside for a diameter", "[geom]") {
    const Sphere sphere{{1.0, 2.0, 3.0}, 0.5};
    const Interval interval = sphere.interval({{1.0, 2.0, -7.0}, {0.0, 0.0, 1.0}}, no_face);
    CHECK(interval.hit);
    CHECK(interval.t0 == 9.5);
    CHECK(interval.t1 == 10.5);
}

TEST_CASE("a tangent misses a sphere, and still says where", "[geom]") {
    const Interval interval = Sphere{}.interval({{1.0, 0.0, -4.0}, {0.0, 0.0, 1.0}}, no_face);
    CHECK_FALSE(interval.hit);
    CHECK(interval.t1 == 4.0);
}

TEST_CASE("a sphere seen from a million away keeps the digits it can", "[geom]") {
    Dice dice(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 d = dice.direction();
        const Ray ray{0.9 * dice.direction() - 1e6 * d, d};
        const Interval interval = Sphere{}.interval(ray, no_face);
        if (!interval.hit) continue;
        const Vec3 p = ray.at(interval.t0);
        const double slope = glm::abs(glm::dot(p, d));
        CHECK(glm::abs(glm::length(p) - 1.0) * slope < 8.0 * unit_roundoff * 2e6);
    }
}

TEST_CASE("ten thousand reflections inside a sphere stay on it", "[geom]") {
    for (const double offset : {0.0, 1e6}) {
        const Sphere sphere{Vec3{offset, 0.5 * offset, -offset}, 1.0};
        Ray ray{sphere.center + Vec3{0.0, 0.6, 0.8}, glm::normalize(Vec3{0.3, -0.8, -0.4})};
        double worst = 0.0;
        for (int i = 0; i < 10000; ++i) {
            const Interval interval = sphere.interval(ray, 0);
            REQUIRE(interval.t0 == 0.0);
            const Vec3 p = on_face(sphere, 0, ray.at(interval.t1)), n = sphere.normal(0, p);
            worst = glm::max(worst, glm::abs(glm::length(p - sphere.center) - 1.0));
            ray = {p, glm::normalize(ray.direction - 2.0 * glm::dot(ray.direction, n) * n)};
        }
        CHECK(worst < 4.0 * unit_roundoff * (1.0 + offset));
    }
}

TEST_CASE("concentric spheres far from the origin stay apart by the ray's finer origin", "[geom]") {
    const Vec3 center{1e6, 1e6, 1e6};
    const Sphere outer{center, 0.8}, inner{center, 0.8 - 1e-12};
    const Vec3 d = glm::normalize(Vec3{0.03, 0.05, 1.0});
    const Ray ray{center - Vec3{0.0, 0.0, 5.0}, d, {1e-11, -2e-11, 3e-11}};
    const double gap = inner.interval(ray, no_face).t0 - outer.interval(ray, no_face).t0;
    CHECK(gap > 0.9e-12);
    CHECK(gap < 1e-11);
}

}  // namespace meniscus::geom
