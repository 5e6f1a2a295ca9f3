#include "compare/difference_picture.hpp"

#include <catch2/catch.hpp>

#include "tests/compare/pictures.hpp"

using namespace meniscus;

TEST_CASE("the difference keeps its sign", "[compare]") {
    const auto comparison = test::two_differences();
    CHECK(compare::signed_error(comparison, 1 * 8 + 5) == Approx(0.5));
    CHECK(compare::signed_error(comparison, 3 * 8 + 2) == Approx(-0.02));
    CHECK(compare::signed_error(comparison, 0) == 0.0);
    const auto values = compare::difference_values(comparison);
    CHECK(values.pixel(5, 1)[1] == Approx(0.5));
    CHECK(values.pixel(2, 3)[2] == Approx(-0.02));
}

TEST_CASE("the map is white without difference, red above and blue below", "[compare]") {
    const auto map = compare::difference_map(test::two_differences(), 0.02);
    for (int c = 0; c < 3; ++c) CHECK(map.pixel(0, 0)[c] == Approx(1.0f));
    CHECK(map.pixel(5, 1)[0] > 2.0f * map.pixel(5, 1)[2]);
    CHECK(map.pixel(2, 3)[2] > 2.0f * map.pixel(2, 3)[0]);
}

TEST_CASE("the suggested scale is a round number at the upper end of the differences",
          "[compare]") {
    const auto a = test::plain(10, 10, 0.0f);
    auto b = a;
    for (int x = 0; x < 10; ++x) b.pixel(x, 0)[0] = 0.0013f;
    const auto comparison = compare::compare(test::side("A", a), test::side("B", b), {});
    CHECK(compare::suggested_scale(comparison) == Approx(2e-3));
    const auto equal = compare::compare(test::side("A", a), test::side("A", a), {});
    CHECK(compare::suggested_scale(equal) == 1.0);
}
