#include "bench/ratios.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/bench/rows.hpp"

using namespace meniscus::bench;
using test::row;

namespace {

/// POV-Ray reaches every error in 20 times our time for the gap, and 30 times that of contact.
Result result() {
    return test::result({row("Meniscus, contact", 0.1, {1.0}),
                         row("Meniscus, contact", 0.01, {100.0}), row("Meniscus, gap", 0.1, {1.5}),
                         row("Meniscus, gap", 0.01, {150.0}), row("POV-Ray, gap", 0.1, {30.0}),
                         row("POV-Ray, gap", 0.02, {750.0})});
}

}  // namespace

TEST_CASE("ratios are read at equal error, and in contact against the gap", "[bench]") {
    const auto ratios = ratios_at_equal_error(result(), {0.05, 0.03});
    REQUIRE(ratios.size() == 4);
    for (const auto& ratio : ratios) {
        INFO(ratio.curve << ' ' << ratio.at);
        CHECK(ratio.peer == "POV-Ray, gap");
        CHECK(ratio.value() == Approx(ratio.curve == "Meniscus, gap" ? 20.0 : 30.0));
    }
    // In contact an error of 0.05 takes 1 s * (0.1 / 0.05)^2.
    CHECK(ratios[2].seconds == Approx(4.0));
    CHECK(ratios[2].error == 0.05);
}

TEST_CASE("no ratio stands beyond what a curve has reached", "[bench]") {
    CHECK(ratios_at_equal_error(result(), {0.2, 0.015, 0.001}).empty());
}

TEST_CASE("errors are chosen from twice the peer's lowest to the largest common one", "[bench]") {
    const auto ratios = ratios_at_equal_error(result(), {});
    REQUIRE(ratios.size() == 6);
    CHECK(ratios[0].error == Approx(0.04));
    CHECK(ratios[1].error == Approx(std::sqrt(0.04 * 0.1)));
    CHECK(ratios[2].error == Approx(0.1));
}

TEST_CASE("no error below twice the reference's own is chosen", "[bench]") {
    auto coarse = result();
    coarse.references[Model::gap].rmse = 0.03;
    CHECK(ratios_at_equal_error(coarse, {}).front().error == Approx(0.06));
    coarse.references[Model::gap].rmse = 0.3;
    CHECK(ratios_at_equal_error(coarse, {}).empty());
}

TEST_CASE("tasks that two curves share are compared as they are", "[bench]") {
    auto rows = std::vector{
        row("Meniscus, contact, general", 0.1, {2.0}), row("Meniscus, contact", 0.1, {7.0}),
        row("Meniscus, contact, recast", 0.1, {3.0}), row("POV-Ray, contact", 0.1, {50.0})};
    rows[0].contender.task = rows[2].contender.task = "contact, --spp 4";
    const auto ratios = ratios_of_equal_tasks(test::result(std::move(rows)));
    REQUIRE(ratios.size() == 1);
    CHECK(ratios[0].peer == "Meniscus, contact, recast");
    CHECK(ratios[0].at == "contact, --spp 4");
    CHECK(ratios[0].value() == 1.5);
}
