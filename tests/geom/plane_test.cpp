#include "geom/plane.hpp"

#include <catch2/catch.hpp>

namespace meniscus::geom {

TEST_CASE("a plane is the half-space below it", "[geom]") {
    const Plane plane{{0.0, 2.0, 0.0}, 1.0};  // the length of the normal does not matter
    CHECK(plane.contains({5.0, 0.999, 5.0}));
    CHECK_FALSE(plane.contains({5.0, 1.0, 5.0}));
    const Interval down = plane.interval({{0.0, 3.0, 0.0}, {0.0, -1.0, 0.0}}, no_face);
    CHECK(down.t0 == 2.0);
    CHECK(down.t1 == infinity);
    CHECK(plane.interval({{0.0, 3.0, 0.0}, {0.0, 1.0, 0.0}}, no_face).t1 == -2.0);
}

TEST_CASE("a line along a plane is wholly inside or wholly outside", "[geom]") {
    const Vec3 along{1.0, 0.0, 0.0};
    const Interval below = Plane{}.interval({{0.0, -1.0, 0.0}, along}, no_face);
    CHECK(below.hit);
    CHECK(below.t0 == -infinity);
    CHECK(below.t1 == infinity);
    CHECK_FALSE(Plane{}.interval({{0.0, 1.0, 0.0}, along}, no_face).hit);
    CHECK_FALSE(Plane{}.interval({{0.0, 0.0, 0.0}, along}, no_face).hit);
}

}  // namespace meniscus::geom
