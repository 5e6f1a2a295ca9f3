#include "geom/transform.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "tests/geom/lines.hpp"

namespace meniscus::geom {

TEST_CASE("quarter turns are exact and left-handed", "[geom]") {
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    CHECK(Transform::rotation_degrees({0, 90, 0}).vector(z) == x);
    CHECK(Transform::rotation_degrees({0, 90, 0}).vector(x) == -z);
    CHECK(Transform::rotation_degrees({90, 0, 0}).vector(y) == z);
    CHECK(Transform::rotation_degrees({0, 0, 90}).vector(x) == y);
    CHECK(Transform::rotation_degrees({0, 0, -450}).vector(y) == x);
    CHECK(Transform::rotation_degrees({0, 180, 0}).vector(x) == -x);
    // About x first, then y, then z.
    CHECK(Transform::rotation_degrees({90, 90, 0}).vector(y) == x);
}

TEST_CASE("transforms apply in the order written", "[geom]") {
    const Transform shift = Transform::translation({1, 0, 0});
    const Transform turn = Transform::rotation_degrees({0, 0, 90});
    CHECK(shift.then(turn).point({0, 0, 0}) == Vec3{0, 1, 0});
    CHECK(turn.then(shift).point({0, 0, 0}) == Vec3{1, 0, 0});
}

TEST_CASE("a transform and its inverse leave points and rays where they were", "[geom]") {
    const Transform there = Transform::scaling({2, 0.5, -1})
                                .then(Transform::rotation_degrees({10, 20, 30}))
                                .then(Transform::translation({1, 2, 3}));
    const Transform round_trip = there.then(there.inverse());
    Dice dice(1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = dice.point(3.0);
        CHECK(glm::length(round_trip.point(p) - p) < 1e-14);
        CHECK(glm::length(there.to_local(there.point(p)) - p) < 1e-14);
        const Ray ray{p, dice.direction()};
        const Ray local = there.to_local(ray);
        CHECK(glm::length(there.point(local.at(2.0)) - ray.at(2.0)) < 1e-14);
        // Normals stay at right angles to the surface.
        const Vec3 n = dice.direction(), along = glm::cross(n, dice.direction());
        CHECK(glm::abs(glm::dot(there.normal(n), there.vector(along))) < 1e-14);
    }
}

TEST_CASE("moving a ray loses nothing", "[geom]") {
    const Transform shift = Transform::translation({1e6 + 0.1, 0.0, 0.0});
    const Ray ray{{0.3, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    const Ray local = shift.to_local(ray);
    CHECK(local.origin_error.x != 0.0);
    // (o - shift) + error, where the sum would round again
    CHECK((local.origin.x + (1e6 + 0.1)) + local.origin_error.x == Approx(0.3).epsilon(1e-9));
}

TEST_CASE("the largest scale is never underestimated", "[geom]") {
    CHECK(Transform::scaling({2, -5, 1}).largest_scale() == 5.0);
    CHECK(Transform::rotation_degrees({12, 34, 56}).largest_scale() == Approx(1.0).epsilon(0.02));
    Dice dice(9);
    for (int i = 0; i < 100; ++i) {
        const Transform t(Mat3{dice.point(2.0), dice.point(2.0), dice.point(2.0)}, Vec3{0.0});
        for (int k = 0; k < 50; ++k) {
            CHECK(glm::length(t.vector(dice.direction())) <= t.largest_scale() * (1.0 + 1e-14));
        }
    }
}

TEST_CASE("a transform that flattens space is refused", "[geom]") {
    CHECK_THROWS_AS(Transform::scaling({1, 0, 1}), std::invalid_argument);
    CHECK_THROWS_AS(Transform(Mat3{Vec3{1, 2, 3}, Vec3{2, 4, 6}, Vec3{0, 0, 1}}, Vec3{0.0}),
                    std::invalid_argument);
}

}  // namespace meniscus::geom
