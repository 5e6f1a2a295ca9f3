#include "compare/sweep.hpp"

#include <catch2/catch.hpp>

using namespace meniscus::compare;
using Catch::Contains;

namespace {

Metrics metrics(double rmse) {
    Metrics result;
    result.pixels = 100;
    result.off = 25;
    result.rmse = rmse;
    return result;
}

Sweep sweep() {
    return {
        "A glass",
        {{1e-1, metrics(0.2), metrics(0.3), metrics(0.4), 1.5, 0.5, "", {}},
         {1e-2, std::nullopt, std::nullopt, metrics(0.1), 0.0, 0.25, "it broke", {}},
         {0.0, metrics(0.02), metrics(0.03), metrics(0.0), 1.0, 0.5, "", {"a <b>", "c \"d\""}}}};
}

}  // namespace

TEST_CASE("steps are powers of ten to the last digit", "[compare]") {
    CHECK(logarithmic_steps(1e-1, 1e-4, 1) == std::vector<double>{1e-1, 1e-2, 1e-3, 1e-4});
    CHECK(logarithmic_steps(1e-1, 1e-2, 2).size() == 3);
    CHECK(logarithmic_steps(1.0, 1e-2, 2)[1] == Approx(0.316227766));
    CHECK(logarithmic_steps(1e-4, 1e-1, 1).back() == 1e-1);
}

TEST_CASE("a sweep is a table for people and for programs", "[compare]") {
    CHECK_THAT(format_csv(sweep()), Contains("0.1,0.2,0.25,0.3,0.25,0.4,0.25,1.5,0.5,\n") &&
                                        Contains("0.01,,,,,0.1,0.25,0,0.25,\n"));
    CHECK_THAT(format_text(sweep()), Contains("no picture") && Contains("it broke"));
    CHECK_THAT(format_markdown(sweep()), Contains("| 0.1 | 2.00e-01 (25.00 %) |"));
}

TEST_CASE("a width whose export warns is marked, in all forms", "[compare]") {
    const auto text = format_text(sweep());
    CHECK_THAT(text, Contains("warning: a <b>\n") && Contains("warning: c \"d\"\n"));
    CHECK(text.find("warning") > text.find("it broke"));
    CHECK_THAT(format_csv(sweep()),
               Contains(",warnings\n") && Contains(",1,0.5,\"a <b>; c \"\"d\"\"\"\n"));
    CHECK_THAT(format_markdown(sweep()), Contains("| 0 \\* | 2.00e-02") && Contains("| 0.1 | ") &&
                                             Contains("\n\n\\* The export warns, as of 0: a <b>"));
    CHECK_THAT(format_page(sweep(), ""),
               Contains("<td class=\"note\" colspan=\"5\">warning: a &lt;b&gt;"));
}

TEST_CASE("a plot shows what is there, and no gap of 0", "[compare]") {
    const auto plot = make_plot(sweep());
    REQUIRE(plot.series.size() == 3);
    CHECK(plot.series[0].points.size() == 1);
    CHECK(plot.series[2].points.size() == 2);
}

TEST_CASE("a sweep is a page of its own, with its command", "[compare]") {
    const auto page = format_page(sweep(), "meniscus compare a.scene --sweep-gap 1e-1:1e-2");
    CHECK_THAT(page, Contains("<!DOCTYPE html>") && Contains("<h1>A glass</h1>") &&
                         Contains("<svg") && Contains("2.00e-01 (25.00 %)") &&
                         Contains("it broke") &&
                         Contains("meniscus compare a.scene --sweep-gap 1e-1:1e-2"));
    CHECK_THAT(page, !Contains("src=\"http") && !Contains("href=\"http"));
}
