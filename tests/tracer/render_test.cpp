#include "tracer/render.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/tracer/scenes.hpp"
#include "tracer/attenuation.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

tracer::Options centers(int width, int height, tracer::Tree tree) {
    tracer::Options options;
    options.width = width;
    options.height = height;
    options.sampling = tracer::GridSampling{1};
    options.tree = tree;
    options.check_segments = true;
    return options;
}

tracer::Rendered render(const scene::Scene& scene, const tracer::Options& options) {
    return tracer::render(tracer::compile(scene), options);
}

double largest_difference(const image::Image& a, const image::Image& b) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        largest = std::max(largest, std::abs(double(a.rgb[i]) - b.rgb[i]));
    return largest;
}

/// Glass ball, water ball across its wall, bubble across the water, over a checkered floor.
scene::Scene overlapping_balls() {
    scene::Scene scene;
    look(scene, {0.3, 2.0, -6.0});
    scene.background.rgb = {0.45, 0.6, 0.85};
    add_glass(scene, geom::Sphere{{-0.4, 0.1, 0.0}, 1.0}, 1.5, 3);
    add_glass(scene, geom::Sphere{{0.5, 0.0, 0.2}, 0.8}, 1.33, 2, {0.3, 0.1, 0.05});
    add_glass(scene, geom::Sphere{{0.8, 0.3, 0.0}, 0.45}, 1.0, 5);
    auto floor = matte(checker({0.85, 0.8, 0.7}, {0.15, 0.2, 0.25}));
    add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.01}, floor);
    scene::Light light;
    light.position = {4.0, 8.0, -5.0};
    scene.lights.push_back(light);
    return scene;
}

/// Cylindrical glass with water whose radius is `reach` more than the inner wall's.
scene::Scene filled_tube(double reach) {
    scene::Scene scene;
    look(scene, {0.5, 2.5, -5.0});
    add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.3},
               emissive(checker({0.9, 0.5, 0.2}, {0.1, 0.3, 0.6})));
    scene.background.rgb = {0.3, 0.5, 0.8};
    // The hollow is air of a higher priority than glass above the water, and the water is higher
    // than the hollow.
    add_glass(scene, geom::Cylinder{{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, 1.0}, 1.5, 1);
    add_glass(scene, geom::Cylinder{{0.0, -0.8, 0.0}, {0.0, 0.3, 0.0}, 0.7 + reach}, 1.33, 0);
    add_glass(scene, geom::Cylinder{{0.0, 0.3, 0.0}, {0.0, 1.5, 0.0}, 0.7}, 1.0, 2);
    return scene;
}

}  // namespace

// Rays down to a pool with a block that reaches 0.008 below the water. At a slope of 1 in 100 they
// leave the block through its bottom within the tolerance of the water's surface, but enter it half
// a unit on.
TEST_CASE("what rays leave with an event they have entered by then", "[tracer]") {
    scene::Scene scene;
    scene.camera = {.kind = scene::Camera::Kind::orthographic,
                    .location = {-3.0, 0.03, 0.0},
                    .direction = {1.0, -0.01, 0.0},
                    .right = {0.0, 0.0, 0.02},
                    .up = {0.0, 0.0002, 0.0}};
    scene.background.rgb = {0.3, 0.5, 0.8};
    scene.settings.contact_tolerance = 0.01;
    add_glass(scene, geom::Plane{{0.0, 1.0, 0.0}, 0.0}, 1.33, 1);
    add_glass(scene, geom::Box{{0.5, -0.008, -1.0}, {2.0, 1.0, 1.0}}, 1.5, 2);
    for (const auto kernel : {tracer::Kernel::general, tracer::Kernel::automatic}) {
        auto options = centers(16, 8, tracer::Tree::full);
        options.check_segments = false;
        options.kernel = kernel;
        CHECK(render(scene, options).statistics.leaks == 0);
    }
}

// Along the axis R = 0.04 is mirrored and half of the way's light is left; what the back mirrors
// does not see the ball any more, so that nothing else is taken from it.
TEST_CASE("a medium that mirrored rays do not see is not in their lists", "[tracer]") {
    scene::Scene scene;
    look(scene, {0.0, 0.0, -6.0});
    scene.background.rgb = scene::Rgb{1.0};
    scene::Object& ball = add_glass(scene, geom::Sphere{{0.0, 0.0, 0.0}, 1.0}, 1.5, 1,
                                    scene::Rgb{0.5 * std::log(2.0)});
    ball.no_reflection = true;
    const auto rendered = render(scene, centers(3, 3, tracer::Tree::full));
    CHECK(rendered.statistics.leaks == 0);
    CHECK(double(rendered.picture.rgb[3 * 4]) == Approx(0.04 + 0.96 * 0.5).epsilon(1e-6));
}

TEST_CASE("a medium that only mirrored rays see is in their lists", "[tracer]") {
    scene::Scene scene;
    look(scene, {0.3, 0.2, -6.0});
    scene.background.rgb = scene::Rgb{1.0};
    add_glass(scene, geom::Box{{-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}}, 1.33, 1, scene::Rgb{0.2})
        .no_image = true;
    add_glass(scene, geom::Sphere{{0.0, 0.0, 0.0}, 1.0}, 1.5, 2);
    CHECK(render(scene, centers(48, 36, tracer::Tree::full)).statistics.leaks == 0);
}

TEST_CASE("a white sphere in a white sky is invisible", "[tracer]") {
    scene::Scene scene;
    look(scene, {0.0, 0.0, -5.0});
    scene.background.rgb = scene::Rgb{1.0};
    add_glass(scene, geom::Sphere{}, 1.5, 1);
    auto options = centers(16, 12, tracer::Tree::full);
    options.cutoff = 1e-12;
    const auto picture = render(scene, options).picture;
    for (const float value : picture.rgb) CHECK_THAT(value, Catch::WithinAbs(1.0, 1e-6));
}

TEST_CASE("a clear slab lets (1-R)/(1+R) through in all", "[tracer]") {
    scene::Scene scene;
    scene.camera.location = {0.0, 0.0, -5.0};
    scene.camera.right = {1e-9, 0.0, 0.0};
    scene.camera.up = {0.0, 1e-9, 0.0};
    add_glass(scene, geom::Box{{-10.0, -10.0, 0.0}, {10.0, 10.0, 1.0}}, 1.5, 1);
    add_opaque(scene, geom::Box{{-10.0, -10.0, 4.0}, {10.0, 10.0, 5.0}},
               emissive(plain(scene::Rgb{1.0})));
    auto options = centers(1, 1, tracer::Tree::full);
    options.cutoff = 1e-12;
    const double r = 0.04;
    CHECK_THAT(render(scene, options).picture.rgb[0],
               Catch::WithinAbs((1.0 - r) / (1.0 + r), 1e-7));
}

TEST_CASE("the sweep and the paper's recast give the same picture in general position",
          "[tracer]") {
    const scene::Scene scene = overlapping_balls();
    auto options = centers(80, 60, tracer::Tree::full);
    options.cutoff = 1e-3;
    const auto sweep = render(scene, options);
    options.interior = tracer::InteriorMode::recast;
    options.check_segments = false;
    const auto recast = render(scene, options);
    // Recast starts each leg at a rounded point; curved mirrors blow that up from bounce to bounce.
    CHECK(largest_difference(sweep.picture, recast.picture) < 1e-5);
    CHECK(sweep.statistics.leaks == 0);
    CHECK(sweep.statistics.true_crossings == recast.statistics.true_crossings);
    CHECK(sweep.statistics.false_crossings == recast.statistics.false_crossings);
    CHECK(sweep.statistics.casts == sweep.statistics.segments);
    CHECK(recast.statistics.casts > recast.statistics.segments);
}

TEST_CASE("the order of declaration changes no byte while priorities differ", "[tracer]") {
    const scene::Scene scene = overlapping_balls();
    scene::Scene reversed = scene;
    std::reverse(reversed.objects.begin(), reversed.objects.end());
    const auto options = centers(60, 45, tracer::Tree::whitted);
    CHECK(render(scene, options).picture.rgb == render(reversed, options).picture.rgb);
}

TEST_CASE("one thread and two give the same bytes and the same counts", "[tracer]") {
    const scene::Scene scene = overlapping_balls();
    for (const tracer::Sampling& sampling :
         {tracer::Sampling(tracer::GridSampling{2}), tracer::Sampling(tracer::CountSampling{8}),
          tracer::Sampling(tracer::ErrorSampling{0.05})}) {
        tracer::Options options;
        options.width = 50;
        options.height = 38;
        options.sampling = sampling;
        options.threads = 1;
        const auto one = render(scene, options);
        options.threads = 2;
        const auto two = render(scene, options);
        CHECK(one.picture.rgb == two.picture.rgb);
        CHECK(one.statistics.segments == two.statistics.segments);
        CHECK(one.statistics.samples == two.statistics.samples);
    }
}

TEST_CASE("water modelled to the very wall is water that reaches into the wall", "[tracer]") {
    const auto options = centers(80, 60, tracer::Tree::full);
    const auto touching = render(filled_tube(0.0), options);
    const auto reaching = render(filled_tube(0.15), options);
    CHECK(touching.statistics.leaks == 0);
    CHECK(reaching.statistics.leaks == 0);
    CHECK(largest_difference(touching.picture, reaching.picture) < 1e-6);
}

TEST_CASE("boxes stacked by decimal fractions are one box", "[tracer]") {
    const auto stack = [](bool split) {
        scene::Scene scene;
        look(scene, {1.0, 1.5, -4.0});
        scene.background.rgb = {0.2, 0.5, 0.9};
        add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
                   emissive(checker({0.9, 0.5, 0.2}, {0.1, 0.3, 0.6})));
        if (split) {
            add_glass(scene, geom::Box{{-0.5, 0.0, -0.5}, {0.5, 0.333, 0.5}}, 1.5, 1);
            add_glass(scene, geom::Box{{-0.5, 0.333, -0.5}, {0.5, 0.333 + 0.333, 0.5}}, 1.5, 1);
            add_glass(scene, geom::Box{{-0.5, 0.666, -0.5}, {0.5, 0.999, 0.5}}, 1.5, 1);
        } else {
            add_glass(scene, geom::Box{{-0.5, 0.0, -0.5}, {0.5, 0.999, 0.5}}, 1.5, 1);
        }
        return scene;
    };
    const auto options = centers(80, 60, tracer::Tree::full);
    const auto three = render(stack(true), options);
    CHECK(three.statistics.leaks == 0);
    CHECK(largest_difference(three.picture, render(stack(false), options).picture) < 1e-6);
}

TEST_CASE("members of one union may overlap: it is counted as one solid", "[tracer]") {
    // Two balls of one solid against the same two balls as solids of like medium.
    scene::Scene apart;
    look(apart, {0.0, 1.0, -5.0});
    apart.background.rgb = {0.2, 0.5, 0.9};
    add_opaque(apart, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
               emissive(checker({0.9, 0.5, 0.2}, {0.1, 0.3, 0.6})));
    add_glass(apart, geom::Sphere{{-0.4, 0.0, 0.0}, 0.8}, 1.5, 1);
    add_glass(apart, geom::Sphere{{0.4, 0.0, 0.0}, 0.8}, 1.5, 1);
    scene::Scene together = apart;
    together.objects[2].solid = together.objects[1].solid;
    const auto options = centers(80, 60, tracer::Tree::full);
    const auto a = render(apart, options), b = render(together, options);
    CHECK(b.statistics.leaks == 0);
    CHECK(largest_difference(a.picture, b.picture) < 1e-6);
}

TEST_CASE("a thousand shells nest without a leak", "[tracer]") {
    scene::Scene scene;
    look(scene, {0.2, 0.3, -4.0});
    scene.background.rgb = {0.7, 0.7, 0.7};
    for (int i = 0; i < 1000; ++i) {
        add_glass(scene, geom::Sphere{{0.0, 0.0, 0.0}, 1.0 - i * 0.9e-3}, 1.0 + 0.0005 * (i + 1),
                  i);
    }
    auto options = centers(8, 6, tracer::Tree::full);
    options.depth = 5000;
    options.cutoff = 0.5;
    const auto result = render(scene, options);
    CHECK(result.statistics.leaks == 0);
    CHECK(result.statistics.deepest_level > 1000);
    // Under a uniform sky only the reflections that the cutoff drops are missing: each of at most
    // 2000 surfaces reflects little.
    const int middle = 3 * (8 * 3 + 4);
    CHECK_THAT(result.picture.rgb[std::size_t(middle)], Catch::WithinAbs(0.7, 0.03));
}

TEST_CASE("a camera inside nested solids starts with their list", "[tracer]") {
    scene::Scene scene;
    scene.camera.location = {0.0, 0.0, 0.0};
    scene.camera.right = {1e-9, 0.0, 0.0};
    scene.camera.up = {0.0, 1e-9, 0.0};
    add_glass(scene, geom::Sphere{{0.0, 0.0, 0.0}, 2.0}, 1.5, 1, {0.5, 0.0, 0.0});
    add_glass(scene, geom::Sphere{{0.0, 0.0, 0.0}, 1.0}, 1.5, 2, {0.0, 0.5, 0.0});
    add_opaque(scene, geom::Box{{-10.0, -10.0, 4.0}, {10.0, 10.0, 5.0}},
               emissive(plain(scene::Rgb{1.0})));
    auto options = centers(1, 1, tracer::Tree::whitted);
    scene.settings.max_trace_level = 3;  // no second reflection
    scene.settings.adc_bailout = 0.1;
    const auto picture = render(scene, options).picture;
    const double through = 0.96 * std::exp(-0.5);
    CHECK_THAT(picture.rgb[0], Catch::WithinAbs(through, 1e-6));
    CHECK_THAT(picture.rgb[1], Catch::WithinAbs(through, 1e-6));
    CHECK_THAT(picture.rgb[2], Catch::WithinAbs(0.96, 1e-6));
}

TEST_CASE("the sampled tree converges to the full one", "[tracer]") {
    const scene::Scene scene = overlapping_balls();
    auto options = centers(24, 18, tracer::Tree::full);
    options.sampling = tracer::GridSampling{16};
    options.cutoff = 1e-5;
    const auto full = render(scene, options);
    options.tree = tracer::Tree::sampled;
    const auto sampled = render(scene, options);
    double difference = 0.0;
    for (std::size_t i = 0; i < full.picture.rgb.size(); ++i) {
        difference += double(sampled.picture.rgb[i]) - full.picture.rgb[i];
    }
    CHECK_THAT(difference / double(full.picture.rgb.size()), Catch::WithinAbs(0.0, 1e-3));
}

TEST_CASE("fading follows its formulas", "[tracer]") {
    scene::Interior medium;
    medium.fade = {.distance = 2.0, .power = 1001.0, .color = {0.9, 0.5, 1.0}};
    CHECK_THAT(tracer::transmittance(medium, 3.0).r, Catch::WithinAbs(std::exp(-0.15), 1e-15));
    CHECK_THAT(tracer::transmittance(medium, 3.0).g, Catch::WithinAbs(std::exp(-0.75), 1e-15));
    CHECK(tracer::transmittance(medium, 3.0).b == 1.0);
    medium.fade.power = 2.0;
    CHECK_THAT(tracer::transmittance(medium, 4.0).g, Catch::WithinAbs(0.5 + 0.5 / 5.0, 1e-15));
}
