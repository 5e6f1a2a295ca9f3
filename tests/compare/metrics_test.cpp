#include "compare/metrics.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/compare/pictures.hpp"

using namespace meniscus;
using compare::measure;
using test::plain;

TEST_CASE("equal pictures do not differ", "[compare]") {
    const auto metrics = measure(plain(5, 3, 0.3f), plain(5, 3, 0.3f), 0.0);
    CHECK(metrics.pixels == 15);
    CHECK(metrics.rmse == 0.0);
    CHECK(metrics.largest == 0.0);
    CHECK(metrics.off == 0);
}

TEST_CASE("a constant difference is its own RMSE, bias and largest difference", "[compare]") {
    const auto metrics = measure(plain(5, 3, 0.5f), plain(5, 3, 0.25f), 0.1);
    CHECK(metrics.rmse == 0.25);
    CHECK(metrics.bias == -0.25);
    CHECK(metrics.largest == 0.25);
    CHECK(metrics.share_off() == 1.0);
}

TEST_CASE("one channel of one pixel weighs one in all values", "[compare]") {
    const auto a = plain(4, 4, 0.0f);
    auto b = a;
    b.pixel(1, 2)[0] = 0.5f;
    const auto metrics = measure(a, b, 0.01);
    CHECK(metrics.rmse == Approx(0.5 / std::sqrt(48.0)));
    CHECK(metrics.bias == Approx(0.5 / 48.0));
    CHECK(metrics.off == 1);
}

TEST_CASE("a pixel off by the threshold itself is not off", "[compare]") {
    CHECK(measure(plain(1, 1, 0.5f), plain(1, 1, 0.75f), 0.25).off == 0);
    CHECK(measure(plain(1, 1, 0.5f), plain(1, 1, 0.75f), 0.2499).off == 1);
}

TEST_CASE("only chosen pixels count", "[compare]") {
    const auto a = plain(2, 1, 0.0f);
    auto b = a;
    b.pixel(0, 0)[1] = 1.0f;
    const std::vector<bool> right = {false, true};
    const auto metrics = measure(a, b, 0.01, &right);
    CHECK(metrics.pixels == 1);
    CHECK(metrics.largest == 0.0);
}

TEST_CASE("what is not finite counts as off and in no mean", "[compare]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const auto a = plain(4, 1, 0.5f);
    auto b = a;
    b.pixel(0, 0)[0] = nan;
    b.pixel(1, 0)[1] = inf;
    const auto metrics = measure(a, b, 0.01);
    CHECK(metrics.not_finite == 2);
    CHECK(metrics.off == 2);
    CHECK(metrics.rmse == 0.0);
    CHECK(measure(b, b, 0.01).off == 0);
}

TEST_CASE("worst pixels come in order and no two are neighbours", "[compare]") {
    // 5 x 1: the second worst stands beside the worst.
    const std::vector<double> errors = {0.9, 0.8, 0.0, 0.3, 0.1};
    CHECK(compare::worst_pixels(errors, 5, 3) == std::vector<std::size_t>{0, 3});
    CHECK(compare::worst_pixels(errors, 5, 1) == std::vector<std::size_t>{0});
    // The end of a row and the begin of the next are not neighbours.
    CHECK(compare::worst_pixels({0.0, 0.0, 0.5, 0.4, 0.0, 0.0}, 3, 2).size() == 2);
}
