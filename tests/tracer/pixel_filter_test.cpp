#include "tracer/pixel_filter.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/tracer/scenes.hpp"
#include "tracer/render.hpp"
#include "tracer/sampler.hpp"

using namespace meniscus;
using namespace meniscus::test;
using tracer::PixelFilter;

namespace {

/// Integrals of the filter times 1, x, x^2, x y, by its own samples.
struct Moments {
    double one = 0.0, x = 0.0, xx = 0.0, xy = 0.0, farthest = 0.0;
};

Moments moments(PixelFilter filter) {
    const tracer::FilterSampler sampler(filter);
    Moments sum;
    const int n = 1 << 16;
    for (int i = 0; i < n; ++i) {
        const auto point = sampler.point(tracer::SobolSet(3).point(std::uint32_t(i)));
        const geom::Vec2 p = point.at - 0.5;
        sum.one += point.weight / n;
        sum.x += point.weight * p.x / n;
        sum.xx += point.weight * p.x * p.x / n;
        sum.xy += point.weight * p.x * p.y / n;
        sum.farthest = std::max({sum.farthest, std::abs(p.x), std::abs(p.y)});
    }
    return sum;
}

/// White to the left of the middle, black to the right: at `x` pixels from the edge, to the left.
double beside_an_edge(PixelFilter filter, int x, tracer::Kernel kernel) {
    scene::Scene scene;
    scene.camera.kind = scene::Camera::Kind::orthographic;
    scene.camera.location = {0, 0, -5};
    scene.camera.direction = {0, 0, 1};
    scene.camera.right = {16, 0, 0};
    scene.camera.up = {0, 8, 0};
    add_opaque(scene, geom::Box{{-20, -20, 0}, {0, 20, 1}}, emissive(plain({1, 1, 1})));
    tracer::Options options;
    options.width = 16;
    options.height = 8;
    options.region = tracer::Region{7 - x, 4, 8 - x, 5};
    options.sampling = tracer::CountSampling{1 << 14};
    options.filter = filter;
    options.kernel = kernel;
    return double(tracer::render(tracer::compile(scene), options).picture.rgb[0]);
}

}  // namespace

TEST_CASE("samples of a pixel filter have its moments", "[tracer][filter]") {
    SECTION("a box has a variance of 1/12") {
        const Moments m = moments(PixelFilter::box);
        CHECK_THAT(m.one, Catch::WithinAbs(1.0, 1e-12));
        CHECK_THAT(m.xx, Catch::WithinAbs(1.0 / 12.0, 1e-5));
        CHECK(m.farthest <= 0.5);
    }
    SECTION("Mitchell's, B / 3: it is between a spline's 1/3 (B = 1) and an interpolator's 0") {
        const Moments m = moments(PixelFilter::mitchell);
        CHECK_THAT(m.one, Catch::WithinAbs(1.0, 1e-3));
        CHECK_THAT(m.x, Catch::WithinAbs(0.0, 1e-3));
        CHECK_THAT(m.xy, Catch::WithinAbs(0.0, 1e-3));
        CHECK_THAT(m.xx, Catch::WithinAbs(1.0 / 9.0, 1e-3));
        CHECK(m.farthest > 1.9);
        CHECK(m.farthest <= 2.0);
    }
    SECTION("Blackman's and Harris', from the integrals of its four cosines") {
        const Moments m = moments(PixelFilter::blackman_harris);
        const double pi = std::acos(-1.0), r = 1.5;
        const double expected =
            r * r *
            (1.0 / 3.0 + 2.0 / (0.35875 * pi * pi) * (-0.48829 + 0.14128 / 4 - 0.01168 / 9));
        CHECK_THAT(m.one, Catch::WithinAbs(1.0, 1e-4));
        CHECK_THAT(m.x, Catch::WithinAbs(0.0, 1e-4));
        CHECK_THAT(m.xx, Catch::WithinAbs(expected, 2e-4));
        CHECK(m.farthest <= 1.5);
    }
}

TEST_CASE("an edge is as soft as its filter, in lanes and without", "[tracer][filter]") {
    const auto kernel = GENERATE(tracer::Kernel::automatic, tracer::Kernel::general);
    // Half a pixel from the edge, then one and a half.
    CHECK_THAT(beside_an_edge(PixelFilter::box, 0, kernel), Catch::WithinAbs(1.0, 1e-6));
    // 1/2 and the integral of (7 v^3 - 12 v^2 + 16/3) / 6 from 0 to 1/2.
    CHECK_THAT(beside_an_edge(PixelFilter::mitchell, 0, kernel),
               Catch::WithinAbs(0.5 + (7.0 / 64.0 - 0.5 + 8.0 / 3.0) / 6.0, 1e-3));
    // Beyond, a negative lobe: brighter than white, by the integral of
    // (-7/3 v^3 + 12 v^2 - 20 v + 32/3) / 6 from 3/2 to 2.
    CHECK_THAT(
        beside_an_edge(PixelFilter::mitchell, 1, kernel),
        Catch::WithinAbs(1.0 - (-7.0 / 12.0 * (16.0 - 81.0 / 16.0) + 4.0 * (8.0 - 27.0 / 8.0) -
                                10.0 * (4.0 - 2.25) + 16.0 / 3.0) /
                                   6.0,
                         1e-3));
    CHECK(beside_an_edge(PixelFilter::mitchell, 1, kernel) > 1.0);
    CHECK_THAT(beside_an_edge(PixelFilter::blackman_harris, 1, kernel),
               Catch::WithinAbs(1.0, 1e-6));
}
