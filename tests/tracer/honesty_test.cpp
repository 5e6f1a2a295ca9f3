#include <catch2/catch.hpp>
#include <cmath>

#include "compare/metrics.hpp"
#include "tests/tracer/scenes.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

scene::Scene checkered_floor() {
    scene::Scene scene;
    test::look(scene, {0.0, 1.0, -5.0});
    test::add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
                     test::emissive(test::checker(scene::Rgb{0.1}, scene::Rgb{0.9})));
    scene.background.rgb = scene::Rgb{0.5};
    return scene;
}

scene::Scene nested_balls() {
    auto scene = checkered_floor();
    test::add_glass(scene, geom::Sphere{geom::Vec3{0.0}, 1.0}, 1.5, 1.0);
    test::add_glass(scene, geom::Sphere{geom::Vec3{0.0}, 0.7}, 1.33, 2.0);
    return scene;
}

}  // namespace

TEST_CASE("adaptive sampling says how far the picture is off, to a fifth", "[tracer]") {
    const auto scene = GENERATE(checkered_floor(), nested_balls());
    const auto compiled = tracer::compile(scene);
    tracer::Options options;
    options.width = 64;
    options.height = 48;
    options.seed = 1;
    options.sampling = tracer::CountSampling{256};
    const auto truth = tracer::render(compiled, options).picture;
    options.seed = 0;
    for (const double wanted : {0.05, 0.02}) {
        options.sampling = tracer::ErrorSampling{wanted};
        const auto rendered = tracer::render(compiled, options);
        const double error = compare::measure(truth, rendered.picture, 0.0).rmse;
        REQUIRE(rendered.estimated_error);
        const double estimated = *rendered.estimated_error;
        INFO("wanted " << wanted << ", estimated " << estimated << ", reached " << error);
        CHECK(estimated <= wanted);
        CHECK(error > 0.8 * estimated);
        CHECK(error < 1.2 * estimated);
    }
}
