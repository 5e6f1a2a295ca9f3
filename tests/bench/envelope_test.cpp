#include "bench/envelope.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace meniscus::bench;

TEST_CASE("the front leaves out whatever another beats in time and error", "[bench]") {
    const std::vector<Reach> points = {{4.0, 0.1}, {1.0, 0.5}, {2.0, 0.6}, {2.0, 0.2},
                                       {3.0, 0.2}, {5.0, 0.1}, {1.0, 0.7}};
    CHECK(pareto_front(points) == std::vector<Reach>{{1.0, 0.5}, {2.0, 0.2}, {4.0, 0.1}});
    CHECK(pareto_front({}).empty());
}

TEST_CASE("points without a logarithm are on no front", "[bench]") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(pareto_front(
              {{0.0, 0.5}, {1.0, 0.0}, {1.0, infinity}, {nan, 0.1}, {1.0, nan}, {2.0, 0.3}}) ==
          std::vector<Reach>{{2.0, 0.3}});
}

TEST_CASE("between points of a front, time follows a power of the error", "[bench]") {
    // Errors of Monte Carlo pictures: a tenth of the error for a hundred times the time.
    const std::vector<Reach> front = {{1.0, 1e-1}, {100.0, 1e-2}};
    for (const double error : {1e-1, 5e-2, 2e-2, 1e-2}) {
        INFO(error);
        CHECK(seconds_at(front, error).value() == Approx(1e-2 / (error * error)));
    }
}

TEST_CASE("a point of the front has its own time", "[bench]") {
    const std::vector<Reach> front = {{1.0, 0.5}, {2.0, 0.2}, {4.0, 0.1}};
    for (const auto& point : front) CHECK(seconds_at(front, point.error) == point.seconds);
    // Half-way in logarithms between 0.5 and 0.2, and so between 1 and 2.
    CHECK(seconds_at(front, std::sqrt(0.5 * 0.2)).value() == Approx(std::sqrt(2.0)));
}

TEST_CASE("nothing is said about errors beyond a front", "[bench]") {
    const std::vector<Reach> front = {{1.0, 0.5}, {2.0, 0.2}};
    CHECK_FALSE(seconds_at(front, 0.51));
    CHECK_FALSE(seconds_at(front, 0.19));
    CHECK_FALSE(seconds_at({}, 0.2));
    CHECK_FALSE(seconds_at(front, std::numeric_limits<double>::quiet_NaN()));
    CHECK(seconds_at({{3.0, 0.2}}, 0.2) == 3.0);
}
