#include "compare/jump_regions.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lang/interpret.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

/// 40 x 40 pixels over [-2, 2] x [-2, 2].
compare::Regions regions(const std::string& objects, const std::string& assumed_gamma = "1") {
    const auto scene = tracer::compile(lang::interpret_text("test.scene",
                                                            R"(#version 3.7;
global_settings { max_trace_level 10 adc_bailout 1e-4 assumed_gamma )" +
                                                                assumed_gamma +
                                                                R"( }
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 4*y }
background { color rgb 0.5 }
)" + objects,
                                                            {})
                                           .scene);
    tracer::Options options;
    options.width = options.height = 40;
    options.sampling = tracer::GridSampling{1};
    return compare::regions_by_jumps(scene, options, tracer::render(scene, options).picture);
}

enum { inside, outside, edges };

bool is(const compare::Regions& regions, int part, int x, int y) {
    return regions.parts[std::size_t(part)].pixels[std::size_t(y) * 40 + std::size_t(x)];
}

}  // namespace

TEST_CASE("a jump is in the band of the pixels that it crosses", "[compare]") {
    const auto seen =
        regions("sphere { 0, 1 pigment { color rgb 0.52 } finish { ambient 1 diffuse 0 } }\n");
    // At half the height of row 20 the silhouette crosses column 10, at 10.01.
    CHECK_FALSE(is(seen, edges, 9, 20));
    CHECK(is(seen, edges, 10, 20));
    CHECK_FALSE(is(seen, edges, 11, 20));
    // At half the width of column 20 it crosses row 10.
    CHECK_FALSE(is(seen, edges, 20, 9));
    CHECK(is(seen, edges, 20, 10));
    CHECK_FALSE(is(seen, edges, 20, 11));
}

TEST_CASE("glass that is as bright as its surroundings has an inside and no edge", "[compare]") {
    const auto seen = regions("sphere { 0, 1 material { ior 1.1 } }\n");
    CHECK(is(seen, inside, 20, 20));
    CHECK(is(seen, outside, 2, 2));
    CHECK(std::ranges::count(seen.parts[edges].pixels, true) == 0);
}

TEST_CASE("in numbers that are not light only what jumps is an edge", "[compare]") {
    const std::string gamma = GENERATE("2.2", "srgb");
    const auto seen = regions(
        "sphere { 0, 1 pigment { color rgb 0.8 } finish { ambient 1 diffuse 0 } }\n", gamma);
    CHECK_FALSE(is(seen, edges, 2, 2));
    CHECK_FALSE(is(seen, edges, 20, 20));
    CHECK(is(seen, edges, 10, 20));
}

TEST_CASE("what changes fast is no edge", "[compare]") {
    // 0 to 1 within six pixels.
    const auto seen = regions(
        "plane { z, 1 pigment { gradient x color_map { [0 rgb 0] [0.5 rgb 1] [1 rgb 0] } scale 0.8 "
        "} "
        "finish { ambient 1 diffuse 0 } }\n");
    CHECK(std::ranges::count(seen.parts[edges].pixels, true) == 0);
}

TEST_CASE("an edge behind a surface of glass is an edge", "[compare]") {
    const auto seen = regions(
        "box { <-3, -3, 0>, <3, 3, 1> material { ior 1.5 } }\n"
        "box { <-3, -3, 2>, <0.02, 3, 3> pigment { color rgb 0.47 } finish { ambient 1 diffuse 0 } "
        "}\n");
    CHECK(is(seen, inside, 5, 20));
    CHECK(is(seen, inside, 35, 20));
    CHECK_FALSE(is(seen, edges, 19, 20));
    CHECK(is(seen, edges, 20, 20));
    CHECK_FALSE(is(seen, edges, 21, 20));
}

TEST_CASE("an opaque object is outside", "[compare]") {
    const auto seen = regions("sphere { 0, 1 pigment { color rgb 0.5 } }\n");
    CHECK(is(seen, outside, 20, 20));
}
