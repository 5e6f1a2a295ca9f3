// What casts shadows: where only opaque surfaces do, rays to lights look for nothing else.

#include <catch2/catch.hpp>

#include "compare/metrics.hpp"
#include "tests/random/random.hpp"
#include "tests/tracer/scenes.hpp"
#include "tests/tracer/shortcut.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

/// A matte floor under clear solids that overlap, with two lights; opaque balls beside, in and
/// across the clear ones.
scene::Scene table(std::uint64_t seed, int opaque_balls) {
    Random random(seed);
    scene::Scene scene;
    look(scene, {0.7, 2.2, -5.0});
    scene.background.rgb = scene::Rgb{0.5, 0.6, 0.9};
    for (const Vec3& position : {Vec3{3.0, 5.0, -4.0}, Vec3{-2.0, 1.5, 1.0}}) {
        scene::Light light;
        light.position = position;
        light.color = scene::Rgb{0.6};
        scene.lights.push_back(light);
    }
    add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
               matte(checker(scene::Rgb{0.2}, scene::Rgb{0.9})));
    for (int i = 0; i < opaque_balls; ++i)
        add_opaque(scene, geom::Sphere{random.point(-1.2, 1.2), random.between(0.1, 0.4)},
                   matte(plain(scene::Rgb{0.7, 0.3, 0.2})));
    add_glass(scene, geom::Box{{-1.6, -1.0, -1.0}, {0.2, 0.8, 1.0}}, 1.33, 2.0);
    for (int i = 0; i < 6; ++i)
        add_glass(scene, geom::Sphere{random.point(-1.5, 1.5), random.between(0.1, 0.6)},
                  1.1 + 0.1 * i, i);
    return scene;
}

tracer::Rendered rendered(const tracer::RenderScene& scene, tracer::Kernel kernel) {
    auto result = tracer::render(scene, full_trees(kernel));
    REQUIRE(result.why_general.empty() == (kernel == tracer::Kernel::automatic));
    return result;
}

}  // namespace

TEST_CASE("to look for opaque surfaces alone on the way to lights changes no picture", "[tracer]") {
    const auto kernel = GENERATE(tracer::Kernel::general, tracer::Kernel::automatic);
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const int opaque_balls = seed % 2 == 0 ? 0 : 3;
        auto scene = tracer::compile(table(seed, opaque_balls));
        INFO("seed " << seed);
        REQUIRE(scene.only_opaque_shades);
        REQUIRE((scene.lone_floor == 0) == (opaque_balls == 0));
        const auto with = rendered(scene, kernel);
        scene.only_opaque_shades = false;
        scene.lone_floor = tracer::outside;
        const auto without = rendered(scene, kernel);
        CHECK(compare::measure(with.picture, without.picture, 0.0).largest == 0.0);
        CHECK(with.statistics.leaks == 0);
        CHECK(with.statistics.true_crossings < without.statistics.true_crossings);
        CHECK(without.statistics.shadow_rays > 0);
        if (opaque_balls == 0) {
            CHECK(with.statistics.shadow_rays == 0);
        } else {
            CHECK(with.statistics.shadow_rays == without.statistics.shadow_rays);
        }
    }
}

TEST_CASE("what takes light away or hides what does is asked on the way to lights", "[tracer]") {
    const auto only_opaque_shades = [](const auto& change) {
        scene::Scene scene = table(1, 1);
        change(scene);
        return tracer::compile(std::move(scene)).only_opaque_shades;
    };
    CHECK(only_opaque_shades([](scene::Scene&) {}));
    CHECK_FALSE(only_opaque_shades([](scene::Scene& scene) {
        scene.solids.back().interior.absorption = scene::Rgb{0.0, 0.1, 0.0};
    }));
    CHECK_FALSE(only_opaque_shades(
        [](scene::Scene& scene) { scene.settings.outside.absorption = scene::Rgb{0.1}; }));
    CHECK_FALSE(only_opaque_shades(
        [](scene::Scene& scene) { scene.solids.back().interior.caustics = 0.5; }));
    CHECK_FALSE(only_opaque_shades([](scene::Scene& scene) {
        add_opaque(scene, geom::Sphere{Vec3{0.0}, 0.2}, matte(plain(scene::Rgb{0.9}, 0.8)));
    }));
    // an opaque solid with a priority may be hidden by glass of a higher one
    CHECK_FALSE(only_opaque_shades([](scene::Scene& scene) {
        scene.solids[1].interior.priority = 1.0;
        scene.solids[1].interior.states_priority = true;
    }));
    CHECK(only_opaque_shades([](scene::Scene& scene) {
        add_opaque(scene, geom::Sphere{Vec3{0.0}, 0.2}, matte(plain(scene::Rgb{0.9}, 0.8)))
            .no_shadow = true;
    }));
}
