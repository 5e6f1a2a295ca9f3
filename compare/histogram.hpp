#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace meniscus::compare {

/// How many pixels have an error of which size: bins of a factor of 10^(1/2), from 1e-7 on.
struct Histogram {
    static constexpr double first = 1e-7;
    static constexpr int bins_per_decade = 2, decades = 7;

    std::vector<std::size_t> counts;  // bins_per_decade * decades of them
    std::size_t below = 0;            // smaller than `first`, 0 included
    std::size_t above = 0;            // 1 and larger, or not finite

    static double lower_bound(std::size_t bin);
    std::size_t pixels() const;
};

Histogram histogram(std::span<const double> errors);

}  // namespace meniscus::compare
