// Solids in, through and against each other: the tracer's pictures equal the oracle's.

#include <catch2/catch.hpp>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/scene_builder.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

/// A checker floor at y = -1.5, a lamp and a sky.
SceneBuilder room(const geom::Vec3& eye = {0.4, 1.3, -6.0}, double angle = 36.0) {
    SceneBuilder builder;
    builder.camera(eye, {0.05, -0.1, 0.0}, angle).sky({0.1, 0.1, 0.2}, {0.5, 0.7, 1.0});
    builder.opaque(geom::Plane{{0, 1, 0}, -1.5}, checker({0.1, 0.15, 0.1}, {0.9, 0.8, 0.7}));
    builder.lamp({-3.1, 6.2, -4.3}, {0.9, 0.8, 0.7});
    return builder;
}

void check_equal(const SceneBuilder& builder, const Picture& picture = {}) {
    const auto difference = compare<Quad>(builder.scene(), picture);
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    CHECK(difference.median < 1e-9);
    CHECK(difference.unexplained == 0);
}

const scene::Rgb amber{0.05, 0.2, 0.6};
const scene::Rgb teal{0.5, 0.1, 0.1};

}  // namespace

TEST_CASE("a ball of glass over a checker", "[oracle][nest]") {
    check_equal(room().glass(geom::Sphere{{0, 0, 0}, 1.0}, 1.5, 0.0));
}

TEST_CASE("nested spheres, the inner of higher or of lower priority", "[oracle][nest]") {
    const bool inner_wins = GENERATE(true, false);
    check_equal(room()
                    .glass(geom::Sphere{{0, 0, 0}, 1.2}, 1.5, inner_wins ? 1 : 3, amber)
                    .glass(geom::Sphere{{0.1, 0, 0}, 0.9}, 1.33, 2, teal)
                    .glass(geom::Sphere{{0, 0.2, 0}, 0.4}, 1.0, inner_wins ? 3 : 1));
}

TEST_CASE("three spheres overlap in pairs and all together", "[oracle][nest]") {
    const int first = GENERATE(1, 2, 3);
    const double p1 = first, p2 = first % 3 + 1, p3 = (first + 1) % 3 + 1;
    check_equal(room()
                    .glass(geom::Sphere{{-0.5, 0, 0}, 0.9}, 1.5, p1, amber)
                    .glass(geom::Sphere{{0.5, 0, 0}, 0.9}, 1.33, p2, teal)
                    .glass(geom::Sphere{{0, 0.6, 0}, 0.8}, 1.8, p3));
}

TEST_CASE("boxes nested, overlapping and stacked face to face", "[oracle][nest]") {
    check_equal(room()
                    .glass(geom::Box{{-1, -1, -1}, {1, 0, 1}}, 1.5, 1, amber)
                    .glass(geom::Box{{-1, 0, -1}, {1, 1, 1}}, 1.33, 2, teal)
                    .glass(geom::Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, 1.0, 3)
                    .glass(geom::Box{{0.5, -0.5, -1.5}, {1.5, 0.5, 0.5}}, 1.8, 0));
}

TEST_CASE("a tumbler with water to the very wall, ice and bubbles", "[oracle][nest]") {
    check_equal(
        room()
            .glass(geom::Cylinder{{0, -1.5, 0}, {0, 1.2, 0}, 1.0, false}, 1.5, 2, amber * 0.2)
            .glass(geom::Cylinder{{0, -1.2, 0}, {0, 1.2, 0}, 0.9, false}, 1.0, 3)
            .glass(geom::Cylinder{{0, -1.2, 0}, {0, 0.6, 0}, 0.9, false}, 1.33, 4, teal)
            .glass(geom::Box{{-0.4, 0.1, -0.4}, {0.3, 0.75, 0.3}}, 1.31, 5)
            .glass(geom::Sphere{{0.4, -0.5, -0.2}, 0.15}, 1.0, 6)
            .glass(geom::Sphere{{-0.3, -0.9, 0.1}, 0.1}, 1.0, 7));
}

TEST_CASE("cones, cylinders and a half-space of water", "[oracle][nest]") {
    check_equal(room()
                    .glass(geom::Plane{{0, 1, 0}, -0.4}, 1.33, 1, teal * 0.3)
                    .glass(geom::Cone{{0, -1.5, 0}, 1.0, {0, 1.0, 0}, 0.25, false}, 1.5, 2)
                    .glass(geom::Cone{{0, 1.2, 0}, 0.8, {0, -1.0, 0}, 0.0, false}, 1.0, 3)
                    .glass(geom::Cylinder{{-1.5, 0, 0.3}, {1.5, 0.2, 0}, 0.3, false}, 1.7, 4));
}

TEST_CASE("a torus half in a ball", "[oracle][nest]") {
    check_equal(room()
                    .glass(geom::Sphere{{0, 0, 0}, 1.0}, 1.33, 1, teal)
                    .glass(geom::Torus{1.0, 0.3}, 1.5, 2, amber,
                           geom::Transform::rotation_degrees({50, 0, 20})));
}

TEST_CASE("the camera is inside of nested media", "[oracle][nest]") {
    check_equal(room({0.1, 0.2, -0.3}, 80.0)
                    .glass(geom::Sphere{{0, 0, 0}, 1.2}, 1.5, 1, amber)
                    .glass(geom::Sphere{{0, 0.1, 0}, 0.9}, 1.33, 2, teal)
                    .glass(geom::Box{{-0.3, -0.3, -0.3}, {0.6, 0.4, 0.2}}, 1.0, 3));
}

TEST_CASE("the outside is a medium too", "[oracle][nest]") {
    scene::Interior water;
    water.ior = 1.33;
    water.absorption = {0.05, 0.02, 0.01};
    check_equal(room()
                    .outside(water)
                    .glass(geom::Sphere{{0, 0, 0}, 1.0}, 1.5, 1)
                    .glass(geom::Sphere{{0.6, 0.2, 0}, 0.7}, 1.0, 2));
}

TEST_CASE("a biconvex lens is a ball and the complement of another", "[oracle][nest]") {
    check_equal(room()
                    .glass(geom::Sphere{{0, 0, 1.2}, 1.6}, 1.5, 1, amber)
                    .glass(geom::Sphere{{0, 0, -1.2}, 1.6}, 1.0, 2)
                    .inverse());
}

TEST_CASE("media that are alike have no surface between them", "[oracle][nest]") {
    check_equal(room()
                    .glass(geom::Sphere{{-0.5, 0, 0}, 0.9}, 1.5, 1, amber)
                    .glass(geom::Sphere{{0.5, 0, 0}, 0.9}, 1.5, 2, amber));
}

TEST_CASE("a union is one solid, whatever its members do", "[oracle][nest]") {
    check_equal(room()
                    .glass(geom::Sphere{{-0.5, 0, 0}, 0.8}, 1.5, 1, amber)
                    .united_with(geom::Sphere{{0.5, 0, 0}, 0.8})
                    .united_with(geom::Cylinder{{-1, 0.5, 0}, {1, 0.5, 0}, 0.4, false})
                    .glass(geom::Box{{-1.2, -0.3, -0.3}, {0.2, 0.3, 0.3}}, 1.2, 2, teal));
}

TEST_CASE("opaque solids end every ray, in the media and out of them", "[oracle][nest]") {
    scene::Finish shining;
    shining.emission = scene::Rgb{0.6};
    scene::Finish mirror;
    mirror.reflection.min = mirror.reflection.max = scene::Rgb{0.5};
    check_equal(room()
                    .glass(geom::Sphere{{0, 0, 0}, 1.2}, 1.5, 1, amber)
                    .opaque(geom::Sphere{{-0.3, 0, 0}, 0.4}, plain({{0.9, 0.3, 0.2}}), shining)
                    .opaque(geom::Box{{0.4, -0.2, -0.3}, {1.5, 0.6, 0.8}}, plain({{0.2, 0.3, 0.4}}),
                            mirror));
}

TEST_CASE("an opaque solid with a priority is seen where a higher one ends in it",
          "[oracle][nest]") {
    scene::Texture paint;
    paint.pigment = checker({0.8, 0.2, 0.1}, {0.9, 0.9, 0.9});
    paint.pigment.transform = geom::Transform::scaling(geom::Vec3{0.2});
    scene::Interior wall;
    wall.priority = 1;
    wall.states_priority = true;
    check_equal(room()
                    .solid(geom::Box{{-1, -1, -1}, {1, 1, 1}}, wall, paint)
                    .glass(geom::Sphere{{0, 0.6, -0.6}, 0.9}, 1.5, 2, teal)
                    .glass(geom::Sphere{{-0.6, 0.2, -1}, 0.3}, 1.0, 3));
}

TEST_CASE("skins with pigment, filter and highlight", "[oracle][nest]") {
    scene::Texture skin;
    skin.pigment = plain({{0.9, 0.5, 0.3}, 0.7, 0.1});
    skin.finish.diffuse = 0.4;
    skin.finish.phong = 0.5;
    skin.finish.specular = 0.3;
    skin.finish.reflection.max = scene::Rgb{1.0};
    skin.finish.reflection.fresnel = true;
    const bool conserves = GENERATE(false, true);
    skin.finish.conserve_energy = conserves;
    check_equal(room()
                    .solid(geom::Sphere{{0, 0, 0}, 1.0}, SceneBuilder::medium(1.5, 1), skin)
                    .glass(geom::Sphere{{0.5, 0.3, -0.5}, 0.6}, 1.33, 2, teal)
                    .solid(geom::Box{{-1.2, -0.4, -0.4}, {-0.2, 0.4, 0.4}},
                           SceneBuilder::medium(1.33, 3), skin));
}

TEST_CASE("an orthographic camera starts inside and outside at once", "[oracle][nest]") {
    auto builder = room()
                       .glass(geom::Sphere{{0.2, 0, 0}, 1.2}, 1.5, 1, amber)
                       .glass(geom::Box{{-0.6, -0.6, -2}, {0.6, 0.6, 2}}, 1.33, 2, teal);
    auto& camera = builder.scene().camera;
    camera.kind = scene::Camera::Kind::orthographic;
    camera.location = {0.011, 0.013, -0.2};
    camera.direction = {0.0, 0.0, 1.0};
    camera.right = {4.0, 0.0, 0.0};
    camera.up = {0.0, 3.0, 0.0};
    check_equal(builder);
}
