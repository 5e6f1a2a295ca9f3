// Solids that touch by what decimal numbers and transformations make of it: no film, no speckle.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <vector>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"
#include "tests/oracle/scene_builder.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

SceneBuilder room(const geom::Vec3& eye = {0.7, 2.1, -5.0}) {
    SceneBuilder builder;
    builder.camera(eye, {0.02, 0.51, 0.0}, 40.0).sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
    return builder;
}

void check_equal(const scene::Scene& scene) {
    const Picture picture{.limits = {.contact = 3e-14}};
    const auto difference = compare<Quad>(scene, picture);
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    CHECK(difference.median < 1e-9);
    CHECK(difference.unexplained == 0);
    CHECK(difference.off * 1000 <= difference.pixels);
}

}  // namespace

TEST_CASE("three boxes 0.333 high stand on each other at 0.333 and 0.666", "[oracle][contact]") {
    auto stack = room();
    for (int i = 0; i < 3; ++i) {
        stack.glass(geom::Box{{-1, 0, -1}, {1, 0.333, 1}}, 1.3 + 0.2 * i, i + 1,
                    {0.1 * i, 0.1, 0.0},
                    geom::Transform::translation({0.0, std::array{0.0, 0.333, 0.666}[i], 0.0}));
    }
    check_equal(stack.scene());
    // The same by other sums.
    auto sums = room();
    sums.glass(geom::Box{{-1, 0, -1}, {1, 0.1 + 0.2, 1}}, 1.5, 2)
        .glass(geom::Box{{-1, 0.3, -1}, {1, 0.9, 1}}, 1.33, 1)
        .glass(geom::Box{{-1, 0.7 + 0.2, -1}, {1, 1.2, 1}}, 1.8, 3);
    check_equal(sums.scene());
}

TEST_CASE("a glass and its water, turned one by one by the same angle", "[oracle][contact]") {
    const auto turn = geom::Transform::rotation_degrees({17.0, 29.0, 41.0});
    const auto lift = geom::Transform::translation({0.0, 0.1, 0.0}).then(turn);
    auto builder = room();
    builder.glass(geom::Cylinder{{0, 0, 0}, {0, 1, 0}, 0.9, false}, 1.5, 1, scene::Rgb{0.0}, turn)
        .glass(geom::Cylinder{{0, 0, 0}, {0, 0.9, 0}, 0.8, false}, 1.0, 2, scene::Rgb{0.0}, lift)
        .glass(geom::Cylinder{{0, 0.1, 0}, {0, 0.7, 0}, 0.8, false}, 1.33, 3, {0.2, 0.1, 0.0},
               turn);
    check_equal(builder.scene());
}

TEST_CASE("an eighth and eight times the tolerance change no picture", "[oracle][contact]") {
    const double factor = GENERATE(0.125, 8.0);
    CAPTURE(factor);
    std::size_t off = 0, unexplained = 0;
    for (std::uint64_t seed = 2000; seed < 2024; ++seed) {
        const RandomSceneOptions options{.rotated = seed % 2 == 1,
                                         .cones = true,
                                         .tori = true,
                                         .meshes = true,
                                         .unions = seed % 3 == 0};
        const auto source = random_scene(seed, options);
        auto scene = tracer::compile(source);
        const Picture picture{.width = 24, .height = 18};
        scene.tolerance_units *= factor;
        const auto difference =
            compare<Extended>(tracer::render(scene, options_for(picture)), source, picture);
        INFO("seed " << seed << ": " << difference.text());
        CHECK(difference.leaks == 0);
        off += difference.off;
        unexplained += difference.unexplained;
    }
    CHECK(unexplained == 0);
    CHECK(off <= 1);
}
