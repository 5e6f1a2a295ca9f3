// Solids that touch by what decimal numbers and transformations make of it: no film, no speckle.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <vector>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/condition.hpp"
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

void check_equal(const scene::Scene& scene, Picture picture = {}, double contact = 3e-14) {
    picture.limits.contact = contact;
    const auto difference = compare<Quad>(scene, picture);
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    CHECK(difference.median < 1e-9);
    CHECK(difference.unexplained == 0);
    CHECK(difference.off * 1000 <= difference.pixels);
}

/// Figure 3's tumbler: one hollow solid of glass, above the water in priority; the water's radius
/// goes `into` the wall.
scene::Scene tumbler(double into, double scale, const geom::Vec3& offset) {
    SceneBuilder builder;
    const auto place =
        geom::Transform::scaling(geom::Vec3{scale}).then(geom::Transform::translation(offset));
    // Numbers that are exact in every place.
    builder.camera(place.point({0.0, 2.5, -7.625}), place.point({0.0, 1.078125, 0.0}), 29.0)
        .sky({0.1, 0.15, 0.2}, {0.9, 0.8, 0.7});
    const geom::Lathe glass(
        geom::Spline::linear,
        {{0.0, 0.0}, {0.75, 0.0}, {0.75, 2.0}, {0.625, 2.0}, {0.625, 0.25}, {0.0, 0.25}});
    const geom::Cylinder water{{0.0, 0.25 - into, 0.0}, {0.0, 1.5, 0.0}, 0.625 + into, false};
    const geom::Box ice{{-0.25, 1.0, -0.25}, {0.25, 1.625, 0.25}};
    builder.glass(glass, 1.5, 3, scene::Rgb{0.0}, place)
        .glass(water, 1.33, 1, scene::Rgb{0.22, 0.07, 0.04} / scale, place)
        .glass(ice, 1.31, 2, scene::Rgb{0.0}, place)
        .glass(geom::Sphere{{0.125, 0.5, -0.125}, 0.125}, 1.0, 2.5, scene::Rgb{0.0}, place);
    return builder.scene();
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

TEST_CASE("water at the wall of its glass and water that reaches into it are the same, anywhere",
          "[oracle][contact]") {
    struct Place {
        double scale;
        geom::Vec3 offset;
        double shift() const {  // tau, in units of `scale`; nothing is farther than 12 away
            const double magnitude = 12.0 * scale + 3.0 * (geom::max_abs(offset) + scale);
            return 16.0 * geom::unit_roundoff * magnitude / scale;
        }
    };
    const Place places[] = {{1.0, geom::Vec3{0.0}},
                            {1e-6, geom::Vec3{0.0}},
                            {1e6, geom::Vec3{0.0}},
                            {1.0, {1e6, 1e6, -1e6}}};
    const double turn = 32.0 * geom::unit_roundoff;
    Picture picture{.limits = {.depth = 10, .cutoff = 1e-3}};

    struct Shown {
        std::size_t place;
        tracer::Rendered picture;
    };
    std::vector<Shown> shown;
    for (const Place& place : places) {
        for (const double into : {0.0, 0.0625}) {
            const double contact = 3e-14 * place.scale + 4e-15 * geom::max_abs(place.offset);
            const auto scene = tumbler(into, place.scale, place.offset);
            check_equal(scene, picture, contact);
            shown.push_back({std::size_t(&place - places), rendered(scene, picture)});
        }
    }

    // One exact picture, and how far each place may be from it (docs/numerics.md, "Pictures").
    Tracer<Extended> exact(tumbler(0.0, 1.0, geom::Vec3{0.0}), picture.limits);
    std::vector<double> bounds[std::size(places)];
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const int w = picture.width, h = picture.height;
            const scene::Rgb truth = exact.pixel(x, y, w, h);
            std::array<scene::Rgb, std::size(places)> bound;
            for (std::size_t i = 0; i < bound.size(); ++i) {
                // All scales have the same share of rounding.
                const double shift = places[i].shift();
                bound[i] = i > 0 && shift <= places[0].shift() * 1.001
                               ? bound[0]
                               : movement(exact, x, y, w, h, shift, turn);
                bounds[i].push_back(geom::max_abs(bound[i]));
            }
            for (std::size_t a = 0; a < shown.size(); ++a) {
                for (int c = 0; c < 3; ++c) {
                    const double seen = shown[a].picture.picture.pixel(x, y)[c];
                    const double rounding = 0x1p-24 * seen;
                    CAPTURE(x, y, c, shown[a].place, seen, truth[c]);
                    CHECK(std::abs(seen - truth[c]) <= bound[shown[a].place][c] + rounding);
                    for (std::size_t b = 0; b < a; ++b) {
                        const double other = shown[b].picture.picture.pixel(x, y)[c];
                        CAPTURE(shown[b].place, other);
                        CHECK(std::abs(seen - other) <= bound[shown[a].place][c] +
                                                            bound[shown[b].place][c] + rounding +
                                                            0x1p-24 * other);
                    }
                }
            }
        }
    }
    // The bounds say something: no pixel lies on a jump.
    for (std::size_t i = 0; i < std::size(places); ++i) {
        const double largest = *std::ranges::max_element(bounds[i]);
        CAPTURE(i, largest);
        CHECK(largest < (places[i].offset == geom::Vec3{0.0} ? 1e-9 : 1e-5));
    }
}
