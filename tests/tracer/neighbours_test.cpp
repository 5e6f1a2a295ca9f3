#include "tracer/neighbours.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/random/random.hpp"
#include "tests/tracer/scenes.hpp"
#include "tests/tracer/shortcut.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

/// A block, the unit cube as a mesh beside it, a floor that one of them touches, and balls of all
/// sizes in, across and outside of them.
scene::Scene crowd(std::uint64_t seed) {
    Random random(seed);
    scene::Scene scene;
    look(scene, {0.7, 1.2, -5.0});
    scene.background.rgb = scene::Rgb{0.5, 0.6, 0.9};
    add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
               emissive(checker(scene::Rgb{0.1}, scene::Rgb{0.9})));
    add_glass(scene, geom::Box{{-1.6, -0.9, -1.0}, {0.2, 0.8, 1.0}}, 1.33, 2.0);
    add_glass(scene, geom::Mesh{}, 1.5, 1.0).transform =
        geom::Transform::scaling(Vec3{0.7}).then(geom::Transform::translation({0.9, -0.3, 0.1}));
    add_opaque(scene, geom::Sphere{{1.0, 0.1, -1.2}, 0.3}, emissive(plain(scene::Rgb{0.7})));
    for (int i = 0; i < 40; ++i) {
        // Media that are alike where priorities tie leave no question which is on top.
        const int priority = random.below(5);
        add_glass(scene, geom::Sphere{random.point(-1.5, 1.5), random.between(0.02, 0.3)},
                  priority == 1   ? 1.5
                  : priority == 2 ? 1.33
                                  : 1.0 + 0.1 * priority,
                  priority);
    }
    return scene;
}

}  // namespace

TEST_CASE("a bubble's neighbour is the block that it is in", "[tracer]") {
    scene::Scene scene;
    add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.1}, matte(plain(scene::Rgb{0.5})));
    add_glass(scene, geom::Box{Vec3{-1.0}, Vec3{1.0}}, 1.33, 1.0);
    for (int i = 0; i < 9; ++i)
        add_glass(scene, geom::Sphere{Vec3{0.2 * i - 0.8, 0.0, 0.0}, 0.09}, 1.0, 2.0);
    add_glass(scene, geom::Sphere{Vec3{0.0, -1.1, 0.0}, 0.05}, 1.5, 1.0);
    auto compiled = tracer::compile(std::move(scene));
    const auto& near = compiled.neighbours.near;
    CHECK(near[0].count == tracer::Neighbours::unknown);  // no medium
    CHECK(near[1].count == tracer::Neighbours::unknown);  // too many
    for (std::size_t i = 2; i < 11; ++i) {
        REQUIRE(near[i].count == 1);
        CHECK(near[i].parts[0] == 1);
    }
    REQUIRE(near[11].count == 1);  // cuts the floor alone
    CHECK(near[11].parts[0] == 0);
}

TEST_CASE("to ask neighbours alone changes no picture", "[tracer]") {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        auto compiled = tracer::compile(crowd(seed));
        REQUIRE(std::ranges::any_of(compiled.neighbours.near,
                                    [](const auto& near) { return near.count >= 0; }));
        const auto forget = [](tracer::RenderScene& scene) {
            scene.neighbours.near.assign(scene.parts.size(), {});
        };
        INFO("seed " << seed);
        check_shortcut(std::move(compiled), forget);
    }
}
