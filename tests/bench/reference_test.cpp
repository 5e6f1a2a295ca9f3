#include "bench/reference.hpp"

#include <catch2/catch.hpp>

#include "compare/metrics.hpp"
#include "tests/tracer/scenes.hpp"

using namespace meniscus;

TEST_CASE("a reference knows how far it is off", "[bench]") {
    scene::Scene scene;
    test::look(scene, {0.0, 1.0, -5.0});
    test::add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
                     test::emissive(test::checker(scene::Rgb{0.0}, scene::Rgb{1.0})));
    scene.background.rgb = scene::Rgb{0.5};
    const auto compiled = tracer::compile(scene);
    tracer::Options options;
    options.width = 32;
    options.height = 24;
    const auto reference = bench::make_reference(compiled, options, 8);

    // A grid of 48 x 48 is another set of points altogether, and off by some thirtieth of that.
    options.sampling = tracer::GridSampling{48};
    const auto truth = tracer::render(compiled, options).picture;
    const auto error = compare::measure(truth, reference.picture, 0.0);
    CHECK(reference.samples == 16);
    CHECK(reference.rmse > 1e-3);
    CHECK(error.rmse > 0.7 * reference.rmse);
    CHECK(error.rmse < 1.4 * reference.rmse);
}

TEST_CASE("an interrupted reference says so", "[bench]") {
    scene::Scene scene;
    test::look(scene, {0.0, 1.0, -5.0});
    const std::atomic<bool> interrupted = true;
    tracer::Options options;
    options.width = options.height = 8;
    options.interrupted = &interrupted;
    CHECK_FALSE(bench::make_reference(tracer::compile(scene), options, 2).is_complete);
}
