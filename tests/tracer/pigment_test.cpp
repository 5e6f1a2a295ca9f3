#include "tracer/pigment.hpp"

#include <catch2/catch.hpp>

#include "tests/tracer/scenes.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

std::shared_ptr<const scene::Pigment> gray(double v) {
    return std::make_shared<scene::Pigment>(plain(scene::Rgb{v}));
}

double value(const scene::Pigment& pigment, const Vec3& p) {
    return tracer::evaluate(pigment, p).rgb.r;
}

scene::Pigment ramp(scene::Gradient gradient) {
    gradient.map = scene::ColorMap{{{0.0, {scene::Rgb{0.0}}}, {1.0, {scene::Rgb{1.0}}}}};
    return {.pattern = gradient, .transform = {}};
}

}  // namespace

TEST_CASE("a checker does not speckle on the planes between its cells", "[tracer]") {
    const scene::Pigment pigment{.pattern = scene::Checker{gray(0.0), gray(1.0)}, .transform = {}};
    CHECK(value(pigment, {0.5, 0.0, 0.5}) == 0.0);
    CHECK(value(pigment, {0.5, -1e-12, 0.5}) == 0.0);
    CHECK(value(pigment, {1.5, 0.0, 0.5}) == 1.0);
    CHECK(value(pigment, {-0.5, 0.0, 0.5}) == 1.0);
    CHECK(value(pigment, {-0.5, 0.0, -0.5}) == 0.0);
}

TEST_CASE("a gradient wraps as POV-Ray's was measured to", "[tracer]") {
    const scene::Pigment pigment = ramp({});
    const auto at = [&](double x) { return value(pigment, {x, 3.0, -2.0}); };
    CHECK(at(0.25) == 0.25);
    CHECK(at(1.0) == 1.0);
    CHECK(at(2.0) == 0.0);
    CHECK_THAT(at(-0.25), Catch::WithinAbs(0.75, 1e-15));
    CHECK_THAT(at(-1e-9), Catch::WithinAbs(1.0, 2e-9));
    CHECK_THAT(at(-1.3), Catch::WithinAbs(0.70001, 1e-9));
    scene::Gradient triangle;
    triangle.wave = scene::Gradient::Wave::triangle;
    CHECK_THAT(value(ramp(triangle), {0.75, 0.0, 0.0}), Catch::WithinAbs(0.5, 1e-15));
}

TEST_CASE("of two map entries at one position the first holds there", "[tracer]") {
    scene::Gradient gradient;
    gradient.map = scene::ColorMap{
        {{0.3, {scene::Rgb{0.2}}}, {0.3, {scene::Rgb{0.9}}}, {0.8, {scene::Rgb{0.4}}}}};
    const scene::Pigment pigment{.pattern = gradient, .transform = {}};
    CHECK(value(pigment, {0.1, 0.0, 0.0}) == 0.2);
    CHECK(value(pigment, {0.3, 0.0, 0.0}) == 0.2);
    CHECK_THAT(value(pigment, {0.55, 0.0, 0.0}), Catch::WithinAbs(0.65, 1e-12));
    CHECK(value(pigment, {0.9, 0.0, 0.0}) == 0.4);
}

TEST_CASE("a hexagon's neighbours take the other two colours", "[tracer]") {
    const scene::Pigment pigment{.pattern = scene::Hexagon{gray(0.0), gray(0.5), gray(1.0)},
                                 .transform = {}};
    CHECK(value(pigment, {0.0, 0.0, 0.0}) == 0.0);
    CHECK(value(pigment, {0.9, 7.0, 0.0}) == 0.0);
    CHECK(value(pigment, {0.0, 0.0, 1.732}) == 0.5);
    CHECK(value(pigment, {0.0, 0.0, -1.732}) == 1.0);
}

TEST_CASE("bricks have mortar of the stated width between them", "[tracer]") {
    const scene::Pigment pigment{.pattern = scene::Brick{gray(0.0), gray(1.0)}, .transform = {}};
    CHECK(value(pigment, {4.0, -0.25, 2.0}) == 0.0);
    CHECK(value(pigment, {4.0, 1.0, 1.0}) == 1.0);
}

TEST_CASE("a pigment's own transform moves its pattern", "[tracer]") {
    scene::Pigment pigment = ramp({});
    pigment.transform =
        geom::Transform::scaling(Vec3{4.0}).then(geom::Transform::translation({1.0, 0.0, 0.0}));
    CHECK_THAT(value(pigment, {2.0, 0.0, 0.0}), Catch::WithinAbs(0.25, 1e-15));
}
