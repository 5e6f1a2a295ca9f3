// Cameras where geometry is least sure: on a surface, in a corner, at the water's level.

#include <catch2/catch.hpp>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/scene_builder.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

/// A ball of water partly in a box of glass, a bubble and a ring.
void check_from(const geom::Vec3& eye, const geom::Vec3& look_at) {
    SceneBuilder builder;
    builder.camera(eye, look_at, 85.0).sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
    builder.glass(geom::Box{{-1, -1, -1}, {1, 1, 1}}, 1.5, 1, {0.1, 0.2, 0.3})
        .glass(geom::Sphere{{0, 0, -1}, 1.0}, 1.33, 2, {0.2, 0.1, 0.0})
        .glass(geom::Sphere{{0.25, 0.25, 0.25}, 0.25}, 1.0, 3)
        .glass(geom::Torus{0.75, 0.25}, 1.8, 4, {0.3, 0.3, 0.3});
    const auto difference = compare<Quad>(builder.scene(), {.width = 16, .height = 12});
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    CHECK(difference.median < 1e-9);
    CHECK(difference.unexplained == 0);
    CHECK(difference.off * 190 <= difference.pixels);
}

}  // namespace

TEST_CASE("the camera is on a face, on a sphere, on a ring", "[oracle][start]") {
    const geom::Vec3 eye =
        GENERATE(geom::Vec3{0.5, 0.25, 1.0}, geom::Vec3{0, 0, -2}, geom::Vec3{0, 1, -1},
                 geom::Vec3{1, 0, 0}, geom::Vec3{0.75, 0.25, 0});
    CAPTURE(eye.x, eye.y, eye.z);
    check_from(eye, {0.013, 0.021, 0.017});
    check_from(eye, 2.0 * eye + geom::Vec3{0.013, 0.021, 0.017});
}

TEST_CASE("the camera is on an edge, in a corner, where sphere and box meet", "[oracle][start]") {
    const geom::Vec3 eye = GENERATE(geom::Vec3{1, 1, 0.25}, geom::Vec3{1, 1, 1},
                                    geom::Vec3{-1, 1, -1}, geom::Vec3{1, 0, -1});
    CAPTURE(eye.x, eye.y, eye.z);
    check_from(eye, {0.013, 0.021, 0.017});
    check_from(eye, 2.0 * eye + geom::Vec3{0.013, 0.021, 0.017});
}

TEST_CASE("the camera is half under water", "[oracle][start]") {
    SceneBuilder builder;
    builder.camera({0.1, 0.0, -4.0}, {0.0, 0.013, 0.0}, 60.0).sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
    builder.glass(geom::Plane{{0, 1, 0}, 0.0}, 1.33, 1, {0.2, 0.1, 0.05})
        .glass(geom::Sphere{{0, 0, 0}, 1.0}, 1.5, 2)
        .opaque(geom::Plane{{0, 1, 0}, -2.0}, checker({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}));
    const auto difference = compare<Quad>(builder.scene());
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    CHECK(difference.median < 1e-9);
    CHECK(difference.unexplained == 0);
}

TEST_CASE("an orthographic film stands half in the water", "[oracle][start]") {
    SceneBuilder builder;
    builder.sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
    builder.glass(geom::Plane{{0, 1, 0}, 0.0}, 1.33, 1, {0.2, 0.1, 0.05})
        .glass(geom::Sphere{{0, 0, 0}, 1.0}, 1.5, 2);
    auto& camera = builder.scene().camera;
    camera.kind = scene::Camera::Kind::orthographic;
    camera.location = {0.0, 0.0, -0.5};  // through the ball, too
    camera.direction = {0.0, 0.0, 1.0};
    camera.right = {4.0, 0.0, 0.0};
    camera.up = {0.0, 3.0, 0.0};
    const auto difference = compare<Quad>(builder.scene());
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    CHECK(difference.unexplained == 0);
}
