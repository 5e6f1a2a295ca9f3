#include "bench/result.hpp"

#include <catch2/catch.hpp>

#include "tests/bench/rows.hpp"

using namespace meniscus::bench;
using test::row;

TEST_CASE("a time is the median of its runs", "[bench]") {
    CHECK(row("a", 0.1, {3.0, 1.0, 9.0}).median_seconds() == 3.0);
    CHECK(row("a", 0.1, {4.0, 1.0, 9.0, 2.0}).median_seconds() == 3.0);
    CHECK(row("a", 0.1, {}).median_seconds() == 0.0);
}

TEST_CASE("a segment's time is the run's over its segments", "[bench]") {
    auto one = row("a", 0.1, {0.002});
    CHECK(one.nanoseconds_a_segment() == 0.0);
    one.counts.segments = 50'000;
    CHECK(one.nanoseconds_a_segment() == Approx(40.0));
}

TEST_CASE("fronts are marked curve by curve", "[bench]") {
    auto result = test::result({row("a", 0.1, {1.0}), row("a", 0.2, {2.0}), row("b", 0.5, {3.0}),
                                row("a", 0.05, {4.0}), row("b", 0.1, {0.0})});
    result.rows.back().failure = "it broke";
    mark_fronts(result);
    std::vector<bool> marks;
    for (const auto& one : result.rows) marks.push_back(one.is_on_front);
    CHECK(marks == std::vector<bool>{true, false, true, true, false});
    CHECK(result.curves() == std::vector<std::string>{"a", "b"});
    CHECK(result.front("a") == std::vector<Reach>{{1.0, 0.1}, {4.0, 0.05}});
}
