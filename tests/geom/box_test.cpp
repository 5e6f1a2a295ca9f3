#include "geom/box.hpp"

#include <catch2/catch.hpp>

namespace meniscus::geom {

TEST_CASE("the corners of a box may be given in any order", "[geom]") {
    const Box box{{1.0, -2.0, 3.0}, {-1.0, 2.0, -3.0}};
    const Interval interval = box.interval({{0.0, 0.0, -10.0}, {0.0, 0.0, 1.0}}, no_face);
    CHECK(interval.hit);
    CHECK(interval.t0 == 7.0);
    CHECK(interval.t1 == 13.0);
    CHECK(box.normal(interval.face0, {}) == Vec3{0.0, 0.0, -1.0});
    CHECK(box.normal(interval.face1, {}) == Vec3{0.0, 0.0, 1.0});
}

TEST_CASE("a line in the shared face of two stacked boxes is in just one of them", "[geom]") {
    const Box lower{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, upper{{0.0, 1.0, 0.0}, {1.0, 2.0, 1.0}};
    const Ray ray{{0.5, 1.0, -3.0}, {0.0, 0.0, 1.0}};
    CHECK_FALSE(lower.interval(ray, no_face).hit);
    CHECK(upper.interval(ray, no_face).hit);
}

TEST_CASE("the way out of a box does not depend on the way in", "[geom]") {
    const Interval interval = Box{}.interval({{3.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, no_face);
    CHECK(interval.t1 == -2.0);
    const Interval beside = Box{}.interval({{0.0, 1.0 + 1e-15, 0.0}, {1.0, 0.0, 0.0}}, no_face);
    CHECK_FALSE(beside.hit);
    CHECK(beside.t1 == 1.0);
}

}  // namespace meniscus::geom
