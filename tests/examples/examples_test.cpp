// Every file in examples/ is a scene that renders without a warning and without a leak.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "lang/interpret.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

const std::filesystem::path folder = EXAMPLES_FOLDER;

tracer::Rendered render(const std::string& name, tracer::InteriorMode mode, int width, int height) {
    lang::Options reading;
    reading.image_width = width;
    reading.image_height = height;
    const auto interpreted = lang::interpret_file(folder / name, reading);
    CHECK(interpreted.warnings.empty());
    tracer::Options options;
    options.width = width;
    options.height = height;
    options.sampling = tracer::GridSampling{1};
    options.interior = mode;
    options.check_segments = mode == tracer::InteriorMode::sweep;
    return tracer::render(tracer::compile(interpreted.scene), options);
}

/// The share of pixels in which the pictures differ by more than `tolerance`.
double share_off(const image::Image& a, const image::Image& b, double tolerance) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    std::size_t off = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        double largest = 0.0;
        for (std::size_t c = i; c < i + 3; ++c)
            largest = std::max(largest, std::abs(double(a.rgb[c]) - b.rgb[c]));
        off += largest > tolerance;
    }
    return double(off) / double(a.rgb.size() / 3);
}

}  // namespace

TEST_CASE("every example renders without warning or leak", "[examples]") {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".scene") continue;
        INFO(entry.path().filename());
        const auto result = render(entry.path().filename(), tracer::InteriorMode::sweep, 32, 24);
        CHECK(result.statistics.leaks == 0);
        CHECK(result.statistics.true_crossings > 0);
        const auto [darkest, brightest] = std::ranges::minmax(result.picture.rgb);
        CHECK(brightest - darkest > 0.1f);
        CHECK(std::ranges::all_of(result.picture.rgb, [](float v) { return std::isfinite(v); }));
        ++count;
    }
    CHECK(count >= 9);
}

// The paper's first advantage: inside the wall of the glass, the water's own shape does not matter.
TEST_CASE("water as a coarse mesh in a fine glass gives the same picture", "[examples]") {
    const auto smooth = render("glass_of_water.scene", tracer::InteriorMode::sweep, 64, 48);
    const auto coarse = render("coarse_water.scene", tracer::InteriorMode::sweep, 64, 48);
    // The mesh's corners lie on circles, its flat top and floor where the cylinder's are: only
    // rounding may differ, which at edges sends a ray the other way.
    CHECK(share_off(smooth.picture, coarse.picture, 1e-6) <= 0.003);
}

// It is not sound where surfaces coincide: a glass that stands on the floor.
TEST_CASE("recast gives the picture of the sweep where the paper's method is sound", "[examples]") {
    for (const char* name :
         {"three_spheres.scene", "first_page.scene", "ocean.scene", "lens.scene"}) {
        INFO(name);
        const auto sweep = render(name, tracer::InteriorMode::sweep, 48, 36);
        const auto recast = render(name, tracer::InteriorMode::recast, 48, 36);
        CHECK(share_off(sweep.picture, recast.picture, 1e-4) <= 0.005);
    }
}
