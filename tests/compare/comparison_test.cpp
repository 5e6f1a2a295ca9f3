#include "compare/comparison.hpp"

#include <catch2/catch.hpp>

#include "compare/json_report.hpp"
#include "tests/compare/pictures.hpp"

using namespace meniscus;
using Catch::Contains;
using test::plain;
using test::side;

TEST_CASE("regions share out the differences", "[compare]") {
    const auto comparison = test::two_differences();
    CHECK(comparison.all.off == 2);
    std::size_t pixels = 0, off = 0;
    for (const auto& part : comparison.by_region) {
        pixels += part.pixels;
        off += part.off;
    }
    CHECK(pixels == 32);
    CHECK(off == 2);
}

TEST_CASE("the worst pixel is told by its place in the whole picture", "[compare]") {
    auto a = plain(3, 2, 0.0f), b = a;
    b.pixel(2, 1)[0] = 1.0f;
    for (auto* picture : {&a, &b}) {
        picture->x0 = 10;
        picture->y0 = 20;
        picture->full_width = picture->full_height = 50;
    }
    const auto comparison = compare::compare(side("A", a), side("B", b), {});
    REQUIRE(comparison.worst.size() == 1);
    CHECK(comparison.worst[0].x == 12);
    CHECK(comparison.worst[0].y == 21);
}

TEST_CASE("a region is compared where the other picture has it", "[compare]") {
    auto whole = plain(10, 8, 0.0f);
    whole.pixel(4, 3)[0] = 0.5f;
    auto part = plain(2, 2, 0.0f);
    part.x0 = 4;
    part.y0 = 3;
    part.full_width = 10;
    part.full_height = 8;
    const auto comparison = compare::compare(side("A", whole), side("B", part), {});
    CHECK(comparison.all.pixels == 4);
    CHECK(comparison.all.largest == 0.5);
}

TEST_CASE("pictures that cannot be laid upon each other are refused", "[compare]") {
    CHECK_THROWS_WITH(compare::compare(side("A", plain(4, 3, 0)), side("B", plain(3, 4, 0)), {}),
                      Contains("A is 4 x 3 pixels and B is 3 x 4"));
    auto left = plain(2, 2, 0), right = left;
    left.full_width = right.full_width = 4;
    right.x0 = 2;
    CHECK_THROWS_WITH(compare::compare(side("A", left), side("B", right), {}),
                      Contains("without a pixel in common"));
}

TEST_CASE("clipped values above 1 are equal", "[compare]") {
    const auto a = side("A", plain(2, 2, 1.0f)), b = side("B", plain(2, 2, 3.0f));
    CHECK(compare::compare(a, b, {}).all.rmse == 2.0);
    CHECK(compare::compare(a, b, {.clip = true}).all.rmse == 0.0);
}

TEST_CASE("text and JSON tell the same numbers", "[compare]") {
    const auto comparison = test::two_differences();
    const auto json = compare::to_json(comparison);
    CHECK(json.at("all").at("largest") == 0.5);
    CHECK(json.at("all").at("off") == 2);
    CHECK(json.at("worst").at(0).at("x") == 5);
    CHECK(json.at("regions").contains("edges"));
    const auto text = compare::format_text(comparison);
    CHECK_THAT(text, Contains("(5, 1) 0.5"));
    CHECK_THAT(text, Contains("6.250 % (2)"));
}
