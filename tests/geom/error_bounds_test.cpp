#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/geom/error_census.hpp"

namespace meniscus::geom {

namespace {

/// c of |error of t| |d.n| <= c u M, as docs/numerics.md states it.
constexpr double bound = 8.0;

void check(Kind kind, int lines) {
    for (const Placement placement : all_placements) {
        const Census found = census(kind, placement, lines, 1);
        INFO(name(kind) << ", " << name(placement) << ", " << found.crossings << " crossings");
        CHECK(found.crossings > found.lines / 4);
        CHECK(found.worst <= bound);
    }
}

}  // namespace

TEST_CASE("crossings obey the law of errors, says quad precision", "[geom]") {
    for (const Kind kind : all_kinds) check(kind, 1000);
}

// The normal's rounding turns a plane about where it was before it was shifted, so that its points
// elsewhere move by the shift's ulps, however near to the origin the plane passes.
TEST_CASE("half-spaces shifted far along themselves obey the law of errors at the origin",
          "[geom]") {
    Dice dice(1);
    for (const Placement placement : {Placement::as_it_is, Placement::moved, Placement::sheared}) {
        double worst = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const Shape plane = random_shape(Kind::plane, dice);
            const Transform turn = random_transform(placement, 0.0, dice);
            const Vec3 n = PlacedShape(plane, turn).normal(0, Vec3{0.0});
            const Vec3 along = glm::normalize(glm::cross(n, dice.direction()));
            const Transform transform =
                turn.then(Transform::translation(log_uniform(0.0, 12.0, dice) * along));
            const PlacedShape shape(plane, transform);
            const Referee referee(plane, transform);
            const double size = log_uniform(-3.0, 3.0, dice);
            for (int line = 0; line < 5; ++line) {
                // Twice: the first time a point that is far from the plane brings its rounding
                // along.
                const Vec3 p = shape.on_face(0, shape.on_face(0, dice.point(size))),
                           d = direction_at(n, dice);
                worst = std::max({worst, error_in_units(shape, referee, {p - size * d, d}, no_face),
                                  error_in_units(shape, referee, {p, d}, 0)});
            }
        }
        INFO(name(placement));
        CHECK(worst <= bound);
    }
}

// 1e5 lines for each kind: some minutes.
TEST_CASE("crossings obey the law of errors on 1e5 lines a shape", "[.][census]") {
    for (const Kind kind : all_kinds) check(kind, 25000);
}

}  // namespace meniscus::geom
