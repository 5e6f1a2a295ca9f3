#include "geom/placed_shape.hpp"

#include <catch2/catch.hpp>

#include "tests/geom/lines.hpp"

namespace meniscus::geom {

TEST_CASE("a transform is taken into a shape's numbers where nothing is lost", "[geom]") {
    const Transform shift = Transform::translation({1, 2, 3});
    const Transform turn = Transform::rotation_degrees({10, 20, 30});
    const Transform stretch = Transform::scaling({1, 2, 3});
    const auto is_taken_in = [](const Shape& shape, const Transform& transform) {
        return PlacedShape(shape, transform).transform().is_identity();
    };
    CHECK(is_taken_in(Sphere{}, shift.then(turn)));
    CHECK(is_taken_in(Sphere{}, Transform::scaling({2, -2, 2})));
    CHECK_FALSE(is_taken_in(Sphere{}, stretch));
    CHECK(is_taken_in(Box{}, stretch.then(shift)));
    CHECK(is_taken_in(Box{}, Transform::rotation_degrees({0, 90, 0})));
    CHECK_FALSE(is_taken_in(Box{}, turn));
    CHECK(is_taken_in(Cylinder{}, shift));
    CHECK_FALSE(is_taken_in(Cylinder{}, Transform::translation({0.1, 0.2, 1e10 / 3.0})));
    CHECK(is_taken_in(Plane{}, stretch.then(turn).then(shift)));
    CHECK(is_taken_in(Triangle{}, stretch.then(turn)));
    CHECK_FALSE(is_taken_in(Torus{}, shift));
}

TEST_CASE("a moved plane is where its points went", "[geom]") {
    const Transform transform = Transform::scaling({1, 2, 3})
                                    .then(Transform::rotation_degrees({10, 20, 30}))
                                    .then(Transform::translation({1, 2, 3}));
    const PlacedShape plane(Plane{{1.0, 1.0, 1.0}, 0.5}, transform);
    Dice dice(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p = dice.point(2.0);
        CHECK(plane.contains(transform.point(p)) == Plane{{1.0, 1.0, 1.0}, 0.5}.contains(p));
    }
}

TEST_CASE("an ellipsoid is met where algebra says", "[geom]") {
    const PlacedShape shape(
        Sphere{}, Transform::scaling({2, 1, 1}).then(Transform::rotation_degrees({0, 0, 90})));
    const Interval interval = shape.interval({{0, -5, 0}, {0, 1, 0}}, no_face);
    CHECK(interval.t0 == Approx(3.0));
    CHECK(interval.t1 == Approx(7.0));
    CHECK(glm::length(shape.normal(0, {0, -2, 0}) - Vec3{0, -1, 0}) < 1e-15);
    CHECK(shape.bounds().high.y >= 2.0);
}

TEST_CASE("a mirrored triangle is met from the same side as before", "[geom]") {
    Crossings before, after;
    PlacedShape(Triangle{}, Transform{}).hits({{0.25, 0.25, -1}, {0, 0, 1}}, before);
    const PlacedShape mirrored(Triangle{}, Transform::scaling({-1, 1, 1}));
    mirrored.hits({{-0.25, 0.25, -1}, {0, 0, 1}}, after);
    REQUIRE(before.size() == 1);
    REQUIRE(after.size() == 1);
    CHECK(before[0].entering == after[0].entering);
    CHECK(mirrored.normal(0, Vec3{0.0}).z == Triangle{}.normal(0, {}).z);
}

}  // namespace meniscus::geom
