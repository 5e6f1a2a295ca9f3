// Ways of finding the same picture: sweep and recast, one thread and two, and many thin shells.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"
#include "tests/oracle/scene_builder.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

/// In generic position: nothing touches, nothing coincides.
SceneBuilder generic_scene() {
    SceneBuilder builder;
    builder.camera({0.37, 1.21, -6.13}, {0.02, 0.03, 0.01}, 40.0)
        .sky({0.1, 0.2, 0.3}, {0.9, 0.8, 0.7})
        .opaque(geom::Plane{{0, 1, 0}, -1.537}, checker({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}))
        .lamp({-3.3, 5.1, -4.7}, {0.8, 0.8, 0.8})
        .glass(geom::Sphere{{0.013, 0.021, -0.017}, 1.1317}, 1.5, 1, {0.1, 0.2, 0.3})
        .glass(geom::Sphere{{0.617, 0.123, 0.219}, 0.8123}, 1.33, 2, {0.3, 0.2, 0.1})
        .glass(geom::Box{{-0.913, -0.411, -0.617}, {0.123, 0.513, 0.719}}, 1.0, 3, scene::Rgb{0.0},
               geom::Transform::rotation_degrees({11, 23, 37}))
        .glass(geom::Cylinder{{-1.31, 0.917, 0.113}, {1.21, 0.719, -0.317}, 0.2113, false}, 1.8, 4);
    return builder;
}

}  // namespace

TEST_CASE("one sweep finds what the paper's recasting finds, where nothing coincides",
          "[oracle][modes]") {
    Picture picture{.width = 96, .height = 72, .limits = {.depth = 8, .cutoff = 1e-3}};
    const auto swept = rendered(generic_scene().scene(), picture);
    picture.interior = tracer::InteriorMode::recast;
    const auto recast = rendered(generic_scene().scene(), picture);
    std::size_t off = 0;
    for (std::size_t i = 0; i < swept.picture.rgb.size(); ++i) {
        if (!(std::abs(swept.picture.rgb[i] - recast.picture.rgb[i]) < 1e-6f)) ++off;
    }
    CHECK(off * 1000 <= swept.picture.rgb.size());
    CHECK(swept.statistics.leaks == 0);
    CHECK(swept.statistics.casts < recast.statistics.casts);
}

TEST_CASE("convex solids need one cast a segment", "[oracle][modes]") {
    const auto swept = rendered(generic_scene().scene());
    CHECK(swept.statistics.casts == swept.statistics.segments);
}

TEST_CASE("any number of threads makes the same bytes", "[oracle][modes]") {
    const std::uint64_t seed = GENERATE(11, 12, 13);
    const auto scene = random_scene(seed, {.rotated = true, .cones = true, .textured = true});
    const auto one = rendered(scene, {}, 1), two = rendered(scene, {}, 2);
    CHECK(one.picture.rgb == two.picture.rgb);
    CHECK(one.statistics.casts == two.statistics.casts);
    CHECK(one.statistics.true_crossings == two.statistics.true_crossings);
    CHECK(one.statistics.false_crossings == two.statistics.false_crossings);
}

TEST_CASE("the order of declaration does not matter where priorities differ", "[oracle][modes]") {
    const std::uint64_t seed = GENERATE(21, 22, 23, 24);
    auto scene = random_scene(seed, {.rotated = true});
    const auto forward = rendered(scene);
    std::reverse(scene.objects.begin(), scene.objects.end());
    const auto backward = rendered(scene);
    CHECK(forward.picture.rgb == backward.picture.rgb);
}

TEST_CASE("a thousand shells, each a little denser than the one around it", "[oracle][modes]") {
    SceneBuilder builder;
    builder.camera({0.0, 0.0, -5.0}, {0.0, 0.0, 0.0}, 20.0).sky({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9});
    constexpr int shells = 1000;
    for (int i = 0; i < shells; ++i) {
        builder.glass(geom::Sphere{{0, 0, 0}, 1.0 - 0.0009 * i}, 1.0 + 0.0005 * (i + 1), i,
                      scene::Rgb{0.001 * i, 0.0, 0.0});
    }
    const Picture picture{.width = 3, .height = 1, .limits = {.depth = 3000, .cutoff = 1e-4}};
    const auto difference = compare<Extended>(builder.scene(), picture);
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    CHECK(difference.median < 1e-9);
    CHECK(difference.far_off == 0);
}

TEST_CASE("a ray through the middle of a thousand shells is dimmed by each of them",
          "[oracle][modes]") {
    SceneBuilder builder;
    builder.camera({0.0, 0.0, -5.0}, {0.0, 0.0, 0.0}, 20.0);
    builder.scene().background = {scene::Rgb{1.0}};
    constexpr int shells = 1000;
    double transmitted = 1.0, optical_depth = 0.0, outer = 1.0;
    for (int i = 0; i < shells; ++i) {
        const double radius = 1.0 - 0.0009 * i, next = i + 1 < shells ? radius - 0.0009 : 0.0;
        const double ior = 1.0 + 0.0005 * (i + 1), r = (ior - outer) / (ior + outer);
        builder.glass(geom::Sphere{{0, 0, 0}, radius}, ior, i, scene::Rgb{0.001 * i});
        transmitted *= (1.0 - r * r) * (1.0 - r * r);  // in and out
        optical_depth += 0.001 * i * 2.0 * (radius - next);
        outer = ior;
    }
    const Picture picture{.width = 1, .height = 1, .limits = {.depth = 3000, .cutoff = 1e-4}};
    const auto seen = rendered(builder.scene(), picture);
    CHECK(seen.picture.rgb[0] == Approx(transmitted * std::exp(-optical_depth)).epsilon(1e-5));
    CHECK(seen.statistics.leaks == 0);
    CHECK(seen.statistics.deepest_level >= 2 * shells);
}
