#include "geom/cylinder.hpp"

#include <catch2/catch.hpp>

#include "geom/shape.hpp"
#include "tests/geom/lines.hpp"

namespace meniscus::geom {

TEST_CASE("a line across a cylinder meets its side, a line along it the caps", "[geom]") {
    const Cylinder cylinder{{0.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, 0.5};
    const Interval across = cylinder.interval({{-2.0, 1.0, 0.0}, {1.0, 0.0, 0.0}}, no_face);
    CHECK(across.t0 == 1.5);
    CHECK(across.t1 == 2.5);
    CHECK(across.face0 == Cylinder::side_face);
    const Interval along = cylinder.interval({{0.1, 5.0, 0.1}, {0.0, -1.0, 0.0}}, no_face);
    CHECK(along.t0 == 2.0);
    CHECK(along.t1 == 5.0);
    CHECK(along.face0 == Cylinder::cap_face);
    CHECK(along.face1 == Cylinder::base_face);
}

TEST_CASE("an open cylinder lets lines through its ends", "[geom]") {
    const Cylinder tube{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5, true};
    CHECK_FALSE(tube.is_closed());
    Crossings hits;
    tube.hits({{0.0, 2.0, 0.0}, {0.0, -1.0, 0.0}}, hits);
    CHECK(hits.empty());
    tube.hits({{0.0, 1.25, 0.0}, glm::normalize(Vec3{0.5, -0.5, 0.0})}, hits);
    REQUIRE(hits.size() == 1);
    CHECK_FALSE(hits[0].entering);  // in through the top, met from within
}

TEST_CASE("ten thousand reflections inside a cylinder stay on it", "[geom]") {
    for (const double offset : {0.0, 1e6}) {
        const Vec3 base{offset, -offset, offset};
        const Cylinder cylinder{base, base + Vec3{0.5, 1.0, 0.25}, 0.7};
        Ray ray{base + Vec3{0.25, 0.5, 0.125}, glm::normalize(Vec3{0.3, -0.8, -0.4})};
        Face pin = no_face;
        double worst = 0.0;
        for (int i = 0; i < 10000; ++i) {
            const Interval interval = cylinder.interval(ray, pin);
            pin = interval.face1;
            const Vec3 p = on_face(cylinder, pin, ray.at(interval.t1));
            worst = glm::max(worst, glm::length(on_face(cylinder, pin, p) - p));
            const Vec3 n = cylinder.normal(pin, p);
            ray = {p, glm::normalize(ray.direction - 2.0 * glm::dot(ray.direction, n) * n)};
        }
        CHECK(worst < 4.0 * unit_roundoff * (2.0 + offset));
        CHECK(cylinder.bounds().padded(1e-9).contains(ray.origin));
    }
}

}  // namespace meniscus::geom
