#include "compare/regions.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/compare/pictures.hpp"

using namespace meniscus;

namespace {

/// 6 x 4, dark to the left of column 3 and light from there on.
image::Image halves() {
    auto picture = test::plain(6, 4, 0.1f);
    for (int y = 0; y < 4; ++y)
        for (int x = 3; x < 6; ++x) picture.pixel(x, y)[2] = 0.9f;
    return picture;
}

std::ptrdiff_t count(const std::vector<bool>& pixels) { return std::ranges::count(pixels, true); }

}  // namespace

TEST_CASE("an edge is one pixel on either side of it", "[compare]") {
    const auto edges = compare::edges_by_contrast(halves());
    for (std::size_t pixel = 0; pixel < edges.size(); ++pixel)
        CHECK(edges[pixel] == (pixel % 6 == 2 || pixel % 6 == 3));
    CHECK(count(compare::edges_by_contrast(halves(), 0.81)) == 0);
}

TEST_CASE("a plain picture has edges and the rest", "[compare]") {
    const auto regions = compare::regions_by_contrast(halves());
    REQUIRE(regions.parts.size() == 2);
    CHECK(count(regions.parts[0].pixels) == 8);
    CHECK(count(regions.parts[1].pixels) == 16);
    CHECK_FALSE(compare::regions_by_layers(halves()));
}

TEST_CASE("layers tell the inside of glass", "[compare]") {
    // One object that is glass in its left half (medium 7) and a wall (no medium) in its right.
    auto picture = test::plain(6, 4, 0.5f);
    std::vector<float> media(24), objects(24, 1.0f);
    for (std::size_t i = 0; i < 24; ++i) media[i] = i % 6 < 3 ? 7.0f : -1.0f;
    picture.layers = {{"medium.ID", media}, {"object.ID", objects}};
    const auto regions = compare::regions_by_layers(picture);
    REQUIRE(regions);
    REQUIRE(regions->parts.size() == 3);
    CHECK(regions->parts[0].name == "inside glass");
    CHECK(regions->parts[0].pixels[0]);
    CHECK(count(regions->parts[0].pixels) == 8);
    CHECK(regions->parts[1].name == "outside");
    CHECK(count(regions->parts[1].pixels) == 8);
    CHECK(regions->parts[2].name == "edges");
    CHECK(count(regions->parts[2].pixels) == 8);
}
