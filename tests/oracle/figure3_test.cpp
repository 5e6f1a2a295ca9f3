// Figure 3 of the paper, at any scale and place: one picture.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <vector>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/condition.hpp"
#include "tests/oracle/scene_builder.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

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
    const Picture picture{.limits = {.depth = 10, .cutoff = 1e-3}};

    struct Shown {
        std::size_t place;
        tracer::Rendered picture;
    };
    std::vector<Shown> shown;
    for (const Place& place : places) {
        for (const double into : {0.0, 0.0625}) {
            const double contact = 3e-14 * place.scale + 4e-15 * geom::max_abs(place.offset);
            const auto scene = tumbler(into, place.scale, place.offset);
            Picture here = picture;
            here.limits.contact = contact;
            const auto difference = compare<Quad>(scene, here);
            CAPTURE(&place - places, into, difference.text());
            CHECK(difference.leaks == 0);
            CHECK(difference.median < 1e-9);
            CHECK(difference.unexplained == 0);
            CHECK(difference.off * 1000 <= difference.pixels);
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
