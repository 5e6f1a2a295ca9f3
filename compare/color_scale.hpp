#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus::compare {

using Srgb = std::array<double, 3>;  // 0 ... 1, as a screen takes it

/// Signed values in [-1, 1]: blue below 0, white at 0, red above; equally far from 0 is equally
/// dark, so that sign and size can both be read off. Beyond the ends the ends' colours.
inline Srgb diverging_color(double value) {
    if (std::isnan(value)) return {1.0, 0.0, 1.0};
    constexpr Srgb low{0.13, 0.40, 0.67}, high{0.70, 0.09, 0.17};
    const double t = std::min(std::abs(value), 1.0);
    const Srgb& end = value < 0.0 ? low : high;
    Srgb result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = 1.0 + t * (end[c] - 1.0);
    return result;
}

}  // namespace meniscus::compare
