#include "compare/histogram.hpp"

#include <cmath>
#include <numeric>

namespace meniscus::compare {

double Histogram::lower_bound(std::size_t bin) {
    return first * std::pow(10.0, double(bin) / bins_per_decade);
}

std::size_t Histogram::pixels() const {
    return std::accumulate(counts.begin(), counts.end(), below + above);
}

Histogram histogram(std::span<const double> errors) {
    Histogram result;
    result.counts.assign(std::size_t(Histogram::bins_per_decade * Histogram::decades), 0);
    for (const double error : errors) {
        if (error < Histogram::first) {
            ++result.below;
        } else if (!(error < 1.0)) {
            ++result.above;
        } else {
            const double place = std::log10(error / Histogram::first) * Histogram::bins_per_decade;
            ++result.counts[std::min(std::size_t(place), result.counts.size() - 1)];
        }
    }
    return result;
}

}  // namespace meniscus::compare
