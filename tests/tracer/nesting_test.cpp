#include "tracer/nesting.hpp"

#include <catch2/catch.hpp>

#include "tests/random/random.hpp"
#include "tests/tracer/scenes.hpp"
#include "tests/tracer/shortcut.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

/// Balls and boxes in each other, each with a place of its own, some with company, of priorities
/// in order, against it, or at random.
scene::Scene nest(std::uint64_t seed) {
    Random random(seed);
    scene::Scene scene;
    look(scene, {0.3, 1.1, -4.0});
    scene.background.rgb = scene::Rgb{0.5, 0.6, 0.9};
    add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.5},
               emissive(checker(scene::Rgb{0.1}, scene::Rgb{0.9})));
    Vec3 center{0.0};
    double radius = 1.2;
    const int depth = 14;
    for (int i = 0; i < depth; ++i) {
        const double priority = seed % 3 == 0 ? i : seed % 3 == 1 ? depth - i : random.below(9);
        // Media that are alike where priorities tie leave no question which is on top.
        const double ior = 1.0 + 0.03 * priority;
        if (i % 4 == 3) {
            const Vec3 half{0.57 * radius};
            add_glass(scene, geom::Box{center - half, center + half}, ior, priority);
            radius *= 0.56;
        } else {
            add_glass(scene, geom::Sphere{center, radius}, ior, priority);
        }
        const double inner = random.between(0.8, 0.95) * radius;
        if (i % 5 == 1) {  // beside what comes next: mostly apart from it, sometimes not
            const double small = 0.2 * radius;
            add_glass(scene, geom::Sphere{center + Vec3{0.75 * radius, 0.0, 0.0}, small}, 1.2, 7.0);
            center.x -= 0.3 * radius;
            radius *= random.between(0.45, 0.68);
            continue;
        }
        center += random.point(-0.5, 0.5) * (radius - inner);
        radius = inner;
    }
    return scene;
}

}  // namespace

TEST_CASE("who holds whom is told by place alone", "[tracer]") {
    scene::Scene scene;
    for (int i = 0; i < 10; ++i) add_glass(scene, geom::Sphere{Vec3{0.0}, 1.0 - 0.09 * i}, 1.5, i);
    add_glass(scene, geom::Sphere{Vec3{1.0, 0.0, 0.0}, 0.05}, 1.5, 0);   // cuts the outermost
    add_glass(scene, geom::Sphere{Vec3{0.0, 0.96, 0.0}, 0.01}, 1.5, 0);  // between the outer two
    add_glass(scene, geom::Sphere{Vec3{5.0, 0.0, 0.0}, 0.1}, 1.5, 0);
    const auto compiled = tracer::compile(scene);
    const tracer::Nesting& nesting = compiled.nesting;
    REQUIRE_FALSE(nesting.is_empty());
    CHECK(nesting.deepest == 9);
    for (int outer = 0; outer < 10; ++outer) {
        for (int inner = 0; inner < 10; ++inner)
            CHECK(nesting.holds(outer, inner) == (outer < inner));
        CHECK_FALSE(nesting.holds(outer, 10));
        CHECK(nesting.holds(outer, 11) == (outer == 0));
        CHECK_FALSE(nesting.holds(outer, 12));
        CHECK_FALSE(nesting.places[std::size_t(outer)].is_alone);
    }
    CHECK(nesting.places[12].is_alone);
}

TEST_CASE("solids that do not stand in each other have no nesting", "[tracer]") {
    scene::Scene scene;
    for (int i = 0; i < 100; ++i)
        add_glass(scene, geom::Sphere{Vec3{i % 10, i / 10, 0.0}, 0.4}, 1.5, 1);
    // Nor those that touch the next one.
    for (int i = 0; i < 10; ++i) {
        const double radius = 1.0 - 0.09 * i;
        add_glass(scene, geom::Sphere{Vec3{20.0 + radius, 0.0, 0.0}, radius}, 1.5, i);
    }
    CHECK(tracer::compile(scene).nesting.is_empty());
}

TEST_CASE("nesting changes no picture", "[tracer]") {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        auto compiled = tracer::compile(nest(seed));
        REQUIRE_FALSE(compiled.nesting.is_empty());
        const auto forget = [](tracer::RenderScene& scene) {
            scene.nesting = {};
            scene.neighbours.near.assign(scene.parts.size(), {});
        };
        INFO("seed " << seed);
        check_shortcut(std::move(compiled), forget);
    }
}
