#include "compare/histogram.hpp"

#include <catch2/catch.hpp>
#include <limits>

using meniscus::compare::Histogram;
using meniscus::compare::histogram;

TEST_CASE("each error stands in the bin that holds it", "[compare]") {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double> errors = {0.0, 5e-8, 2e-7, 0.02, 0.5, 1.0, infinity};
    const auto bins = histogram(errors);
    CHECK(bins.below == 2);
    CHECK(bins.above == 2);
    CHECK(bins.pixels() == errors.size());
    for (const double error : {2e-7, 0.02, 0.5}) {
        std::size_t bin = 0;
        while (Histogram::lower_bound(bin + 1) <= error) ++bin;
        CHECK(bins.counts.at(bin) == 1);
    }
}
