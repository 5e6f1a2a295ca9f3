#pragma once

#include <cmath>

#include "geom/vec.hpp"

namespace meniscus::povray {

inline constexpr double golden_angle = 2.399963229728653;

/// Unit vector `i` of `count` that are spread evenly over all directions: Fibonacci's lattice.
inline geom::Vec3 spread_direction(int i, int count) {
    const double y = (2.0 * i + 1.0) / count - 1.0, r = std::sqrt(1.0 - y * y);
    return {r * std::cos(i * golden_angle), y, r * std::sin(i * golden_angle)};
}

}  // namespace meniscus::povray
