#include "lanes/chance.hpp"

#include <catch2/catch.hpp>

using namespace meniscus::lanes;

TEST_CASE("a choice between two branches keeps what both carry, on the mean", "[lanes]") {
    const double r = 0.3, t = 0.7;
    const int n = 100000;
    double mirror = 0.0, through = 0.0;
    for (int i = 0; i < n; ++i) {
        const Branches branches = choose(true, r, true, t, 0.1, std::uint64_t(i));
        CHECK(branches.mirror != branches.through);
        if (branches.mirror) mirror += r * branches.mirror_gain;
        if (branches.through) through += t * branches.through_gain;
    }
    // Standard error of a binomial share: sqrt(0.3 * 0.7 / n) = 1.45e-3; five of it.
    CHECK(mirror / n == Approx(r).margin(7.3e-3));
    CHECK(through / n == Approx(t).margin(7.3e-3));
}

TEST_CASE("both branches are followed while the weight is high, and one if there is one",
          "[lanes]") {
    const Branches both = choose(true, 0.5, true, 0.5, split_above, 7);
    CHECK((both.mirror && both.through));
    CHECK(both.mirror_gain == 1.0);
    const Branches only = choose(true, 0.5, false, 0.0, 0.01, 7);
    CHECK((only.mirror && !only.through));
    CHECK(only.mirror_gain == 1.0);
}

TEST_CASE("rays that survive carry the light of those that do not", "[lanes]") {
    const double weight = 0.25 * roulette_below;
    const int n = 100000;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += weight * survive(weight, std::uint64_t(i));
    // A quarter survives, with four times the weight: standard error sqrt(3 / n) = 5.5e-3.
    CHECK(sum / n / weight == Approx(1.0).margin(2.8e-2));
    CHECK(survive(roulette_below, 1) == 1.0);
}
