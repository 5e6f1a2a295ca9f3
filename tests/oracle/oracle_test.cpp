// The oracle itself: known answers, and the same answer at every precision.

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/oracle/random_scene.hpp"
#include "tests/oracle/scene_builder.hpp"
#include "tests/oracle/trace.hpp"

using namespace meniscus;
using namespace meniscus::oracle;
using Catch::Matchers::WithinAbs;

namespace {

/// Along z at x = y = 0.
SceneBuilder ahead(const scene::Rgb& background) {
    SceneBuilder builder;
    builder.camera({0.0, 0.0, -10.0}, {0.0, 0.0, 0.0}, 30.0);
    builder.scene().background = {background};
    return builder;
}

template <class Real>
scene::Rgb look(const scene::Scene& scene, const Limits& limits = {}) {
    return Tracer<Real>(scene, limits).pixel(0, 0, 1, 1);
}

double largest_difference(const std::vector<scene::Rgb>& a, const std::vector<scene::Rgb>& b,
                          std::size_t* off = nullptr) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = geom::max_abs(a[i] - b[i]);
        if (off && difference > 1e-6) ++*off;
        largest = std::max(largest, difference);
    }
    return largest;
}

}  // namespace

TEMPLATE_TEST_CASE("a slab of glass lets 2n over n^2 + 1 through", "[oracle]", double, Extended,
                   Quad) {
    auto builder = ahead(scene::Rgb{1.0});
    builder.glass(geom::Box{{-5, -5, 0}, {5, 5, 1}}, 1.5, 1.0);
    builder.opaque(geom::Plane{{0, 0, -1}, -20.0}, plain({scene::Rgb{0.0}}));
    const auto seen =
        look<TestType>(builder.scene());  // white in front, black behind: what is reflected
    CHECK_THAT(seen.r, WithinAbs(1.0 - 2.0 * 1.5 / (1.5 * 1.5 + 1.0), 1e-6));
}

TEMPLATE_TEST_CASE("two media in contact have one surface and no film", "[oracle]", double,
                   Extended, Quad) {
    auto builder = ahead(scene::Rgb{0.0});
    builder.glass(geom::Box{{-5, -5, 0.1}, {5, 5, 0.3}}, 1.5, 2.0);
    builder.glass(geom::Box{{-5, -5, 0.1 + 0.2}, {5, 5, 1}}, 1.33, 1.0, scene::Rgb{0.7});
    scene::Finish shining;
    shining.ambient = scene::Rgb{1.0};
    shining.diffuse = 0.0;
    builder.opaque(geom::Plane{{0, 0, -1}, -1.0}, plain({scene::Rgb{1.0}}), shining);
    const double r1 = 0.04, r2 = std::pow(0.17 / 2.83, 2.0);
    const auto seen = look<TestType>(builder.scene(), {.depth = 3, .cutoff = 0.0});
    CHECK_THAT(seen.r, WithinAbs((1 - r1) * (1 - r2) * std::exp(-0.7 * 0.7), 1e-12));
}

TEMPLATE_TEST_CASE("the higher priority wins where solids overlap", "[oracle]", double, Extended,
                   Quad) {
    const bool water_wins = GENERATE(false, true);
    auto builder = ahead(scene::Rgb{1.0});
    builder.glass(geom::Box{{-5, -5, 0}, {5, 5, 2}}, 1.0, water_wins ? 1.0 : 2.0, scene::Rgb{1.0});
    builder.glass(geom::Sphere{{0, 0, 2}, 1.0}, 1.0, water_wins ? 2.0 : 1.0, scene::Rgb{0.1});
    const double expected = water_wins ? std::exp(-1.0 - 0.2) : std::exp(-2.0 - 0.1);
    CHECK_THAT(look<TestType>(builder.scene()).r, WithinAbs(expected, 1e-12));
}

TEST_CASE("a shadow takes absorption and filter but no Fresnel", "[oracle]") {
    auto builder = ahead(scene::Rgb{0.0});
    scene::Finish matt;
    matt.ambient = scene::Rgb{0.0};
    matt.diffuse = 1.0;
    builder.opaque(geom::Plane{{0, 0, -1}, 0.0}, plain({scene::Rgb{1.0}}), matt);
    builder.glass(geom::Box{{-5, 1, -3}, {5, 2, -1}}, 1.5, 1.0, scene::Rgb{0.3});
    builder.lamp({0, 3, -3}, scene::Rgb{1.0});
    const double slant = std::sqrt(2.0);  // 45 degrees through the box from y = 1 to y = 2
    CHECK_THAT(look<Quad>(builder.scene()).r, WithinAbs(std::exp(-0.3 * slant) / slant, 1e-12));
}

TEST_CASE("a complement as air cuts a lens out of a ball", "[oracle]") {
    auto builder = ahead(scene::Rgb{1.0});
    builder.glass(geom::Sphere{{0, 0, 0.6}, 1.0}, 1.5, 1.0, scene::Rgb{1.0});
    builder.glass(geom::Sphere{{0, 0, -0.6}, 1.0}, 1.0, 2.0).inverse();
    const auto seen = look<Quad>(builder.scene(), {.depth = 3, .cutoff = 0.0});
    CHECK_THAT(seen.r, WithinAbs(0.04 + 0.96 * 0.96 * std::exp(-0.8), 1e-12));
}

TEST_CASE("a torus is met in up to four places", "[oracle]") {
    auto builder = ahead(scene::Rgb{1.0});
    builder.glass(geom::Torus{2.0, 0.5}, 1.0, 1.0, scene::Rgb{0.5});
    CHECK_THAT(look<Quad>(builder.scene()).r, WithinAbs(std::exp(-0.5 * 2.0), 1e-12));
}

TEST_CASE("all precisions agree on random lattice scenes", "[oracle]") {
    const bool rotated = GENERATE(false, true);
    std::size_t off = 0, pixels = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const auto scene = random_scene(seed, {.rotated = rotated, .cones = true});
        const Limits limits{.depth = 6, .cutoff = 1e-2};
        const auto quad = picture<Quad>(scene, 12, 9, limits);
        const auto extended = picture<Extended>(scene, 12, 9, limits);
        largest_difference(quad, extended, &off);
        largest_difference(quad, picture<double>(scene, 12, 9, limits), &off);
        pixels += 2 * quad.size();
    }
    INFO(off << " of " << pixels << " pixels");
    CHECK(off == 0);
}
