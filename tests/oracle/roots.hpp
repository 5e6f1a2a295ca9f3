#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tests/oracle/real.hpp"

namespace meniscus::oracle {

/// Real roots of c[0] + c[1] t + ... + c[n] t^n in [low, high], sorted: between two neighbouring
/// extrema a polynomial is monotone, and its extrema are the roots of its derivative.
template <class Real>
std::vector<Real> real_roots(const std::vector<Real>& c, Real low, Real high) {
    const auto value = [&](Real t) {
        Real sum = 0;
        for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
        return sum;
    };
    if (c.size() < 2) return {};
    if (c.size() == 2) {
        if (c[1] == 0) return {};
        const Real t = -c[0] / c[1];
        if (t < low || t > high) return {};
        return {t};
    }
    std::vector<Real> derivative;
    for (std::size_t i = 1; i < c.size(); ++i) derivative.push_back(Real(int(i)) * c[i]);
    std::vector<Real> stops{low};
    for (const Real t : real_roots(derivative, low, high)) stops.push_back(t);
    stops.push_back(high);

    std::vector<Real> roots;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        Real a = stops[i], b = stops[i + 1];
        const Real at_a = value(a), at_b = value(b);
        if (at_a == 0) roots.push_back(a);
        if ((at_a < 0) == (at_b < 0) || at_a == 0 || at_b == 0) continue;
        for (int step = 0; step < 200; ++step) {
            const Real middle = (a + b) / 2;
            if (middle == a || middle == b) break;
            ((value(middle) < 0) == (at_a < 0) ? a : b) = middle;
        }
        roots.push_back((a + b) / 2);
    }
    return roots;
}

}  // namespace meniscus::oracle
