#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "compare/metrics.hpp"
#include "tests/tracer/scenes.hpp"
#include "tests/tracer/shortcut.hpp"
#include "tracer/light_at.hpp"
#include "tracer/render.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

/// One pixel that looks straight at the plane z = 0 from z = -1, lit under `angle_degrees`.
scene::Scene wall(const scene::Texture& texture, double angle_degrees) {
    scene::Scene scene;
    scene.camera.location = {0.0, 0.0, -1.0};
    scene.camera.right = {1e-9, 0.0, 0.0};
    scene.camera.up = {0.0, 1e-9, 0.0};
    add_opaque(scene, geom::Plane{{0.0, 0.0, -1.0}, 0.0}, texture);
    const double angle = angle_degrees * std::numbers::pi / 180.0;
    scene::Light light;
    light.position = 100.0 * Vec3{std::sin(angle), 0.0, -std::cos(angle)};
    scene.lights.push_back(light);
    return scene;
}

double shade(const scene::Scene& scene, int channel = 0) {
    tracer::Options options;
    options.width = options.height = 1;
    options.sampling = tracer::GridSampling{1};
    return tracer::render(tracer::compile(scene), options).picture.rgb[std::size_t(channel)];
}

scene::Texture white() {
    scene::Texture texture;
    texture.pigment = plain(scene::Rgb{1.0});
    return texture;
}

}  // namespace

// The figures on the right are POV-Ray 3.7's, read from 16-bit linear pictures of the same
// arrangement.
TEST_CASE("diffuse light and highlights are POV-Ray's", "[tracer]") {
    auto texture = white();
    CHECK_THAT(shade(wall(texture, 45.0)), Catch::WithinAbs(0.52427, 2e-5));
    texture.finish.ambient = scene::Rgb{0.0};
    texture.finish.diffuse = 0.7;
    texture.finish.brilliance = 2.0;
    CHECK_THAT(shade(wall(texture, 35.0)), Catch::WithinAbs(0.46970, 2e-5));
    texture.finish = {};
    texture.finish.ambient = scene::Rgb{0.0};
    texture.finish.diffuse = 0.0;
    texture.finish.phong = 0.5;
    texture.finish.phong_size = 20.0;
    CHECK_THAT(shade(wall(texture, 35.0)), Catch::WithinAbs(0.00925, 2e-5));
    texture.finish.phong = 0.0;
    texture.finish.specular = 0.5;
    CHECK_THAT(shade(wall(texture, 35.0)), Catch::WithinAbs(0.19380, 2e-5));
    texture.finish.metallic = 1.0;
    texture.pigment = plain({1.0, 0.5, 0.2});
    CHECK_THAT(shade(wall(texture, 35.0), 1), Catch::WithinAbs(0.09842, 2e-5));
    CHECK_THAT(shade(wall(texture, 35.0), 2), Catch::WithinAbs(0.04119, 2e-5));
}

TEST_CASE("a light fades by 2 / (1 + (d / distance)^power)", "[tracer]") {
    scene::Light light;
    light.position = {0.0, 6.0, 0.0};
    light.fade_distance = 3.0;
    light.fade_power = 2.0;
    CHECK_THAT(tracer::light_at(light, {0.0, 0.0, 0.0}).color.r, Catch::WithinAbs(0.4, 1e-15));
    light.fade_power = 0.0;
    CHECK(tracer::light_at(light, {0.0, 0.0, 0.0}).color.r == 1.0);
}

TEST_CASE("a parallel light comes from one direction and is as far as its plane", "[tracer]") {
    scene::Light light;
    light.position = {0.0, 6.0, 0.0};
    light.point_at = {0.0, 0.0, 0.0};
    light.parallel = true;
    const auto seen = tracer::light_at(light, {50.0, 1.0, -3.0});
    CHECK(seen.direction == Vec3{0.0, 1.0, 0.0});
    CHECK(seen.distance == 5.0);
}

TEST_CASE(
    "a spotlight is full inside its radius, dark outside its falloff, smooth in the cosine between",
    "[tracer]") {
    scene::Light light;
    light.kind = scene::Light::Kind::spot;
    light.position = {0.0, 0.0, 0.0};
    light.point_at = {0.0, 0.0, 1.0};
    light.radius = 10.0;
    light.falloff = 30.0;
    const auto at = [&](double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return tracer::light_at(light, {5.0 * std::sin(a), 0.0, 5.0 * std::cos(a)}).color.r;
    };
    CHECK(at(9.0) == 1.0);
    CHECK(at(31.0) == 0.0);
    const double c10 = std::cos(10.0 * std::numbers::pi / 180.0),
                 c30 = std::cos(30.0 * std::numbers::pi / 180.0);
    const double halfway = std::acos(0.5 * (c10 + c30)) * 180.0 / std::numbers::pi;
    CHECK_THAT(at(halfway), Catch::WithinAbs(0.5, 1e-12));
}

TEST_CASE("shadows take absorption and the skins' colour, and straight lines", "[tracer]") {
    auto texture = white();
    texture.finish.ambient = scene::Rgb{0.0};
    texture.finish.diffuse = 1.0;
    scene::Scene scene = wall(texture, 0.0);
    scene.lights[0].position = {5.0, 0.0, -5.0};
    const double lit = shade(scene);
    CHECK_THAT(lit, Catch::WithinAbs(std::sqrt(0.5), 1e-6));
    // A slab between: 45 degrees through 0.5 units of absorbing glass.
    add_glass(scene, geom::Box{{1.0, -10.0, -10.0}, {1.5, 10.0, -1e-3}}, 1.5, 1, {0.8, 0.0, 0.0});
    CHECK_THAT(shade(scene), Catch::WithinAbs(lit * std::exp(-0.8 * 0.5 * std::sqrt(2.0)), 1e-6));
    CHECK_THAT(shade(scene, 1), Catch::WithinAbs(lit, 1e-6));
    // An opaque ball inside ends it.
    add_opaque(scene, geom::Sphere{{2.0, 0.0, -2.0}, 0.2}, white());
    CHECK(shade(scene) == 0.0);
}

TEST_CASE("what a sloppy model stands on has the colour of its own place", "[tracer]") {
    // The floor lies 1e-6 below the plane in which the checker's next cell begins.
    const auto kernel = GENERATE(tracer::Kernel::general, tracer::Kernel::automatic);
    const auto picture = [&](double bottom) {
        scene::Scene scene;
        look(scene, {0.3, 4.0, -0.2});
        scene.settings.contact_tolerance = 1e-5;
        scene.background.rgb = scene::Rgb{0.5};
        add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1e-6},
                   emissive(checker(scene::Rgb{0.2}, scene::Rgb{0.9})));
        add_glass(scene, geom::Box{{-0.9, bottom, -0.9}, {0.9, 0.5, 0.9}}, 1.2, 1.0);
        return tracer::render(tracer::compile(scene), full_trees(kernel)).picture;
    };
    CHECK(compare::measure(picture(0.0), picture(-1e-6), 0.01).share_off() < 0.01);
}
