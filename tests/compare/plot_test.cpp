#include "compare/plot.hpp"

#include <catch2/catch.hpp>

using namespace meniscus::compare;
using Catch::Contains;

TEST_CASE("a plot names its axes, its curves and its powers of ten", "[compare]") {
    const auto svg = draw(Plot{"T & U", "gap", "RMSE", {{"first", {{1e-4, 1e-2}, {1e-1, 0.5}}}}});
    CHECK_THAT(svg, Contains("T &amp; U") && Contains(">gap<") && Contains(">first<"));
    CHECK_THAT(svg, Contains("10⁻⁴") && Contains("10⁻¹") && Contains("10⁰"));
}

TEST_CASE("a value at a power of ten stands on its line", "[compare]") {
    // Decades 1e-2 ... 1e0 over the height of 320 from 44 on: 1e-1 lies half-way, at 204.
    const auto svg =
        draw(Plot{"", "", "", {{"s", {{1e-2, 1e-2}, {1e-1, 1e-1}, {1.0, 1.0}}, false, false}}});
    CHECK_THAT(svg, Contains("M78.0 364.0L389.0 204.0L700.0 44.0"));
}

TEST_CASE("a logarithmic axis leaves zeros out", "[compare]") {
    const auto svg =
        draw(Plot{"", "", "", {{"s", {{1e-2, 0.0}, {1e-1, 1e-1}, {1.0, 1.0}}, false, false}}});
    CHECK_THAT(svg, !Contains("nan") && !Contains("inf"));
    CHECK_THAT(draw(Plot{"", "", "", {{"s", {}}}}), !Contains("nan"));
}

TEST_CASE("a bar without pixels is not there and one of a single pixel is", "[compare]") {
    const auto svg =
        draw(Bars{"", "", "", {{"a", "none", 0.0}, {"b", "one", 1.0}, {"c", "many", 900.0}}});
    CHECK_THAT(svg, !Contains("none: 0") && Contains("one: 1") && Contains("many: 900"));
}
