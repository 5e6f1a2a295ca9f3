#include "geom/polynomial.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace meniscus::geom {

namespace {

struct Jet {
    double value, slope;
};

Jet evaluate_with_slope(std::span<const double> c, double x) {
    Jet jet{0.0, 0.0};
    for (std::size_t i = c.size(); i-- > 0;) {
        jet.slope = jet.slope * x + jet.value;
        jet.value = jet.value * x + c[i];
    }
    return jet;
}

Roots quadratic_roots(std::span<const double> c, double low, double high) {
    Roots roots;
    const double half_b = 0.5 * c[1], discriminant = half_b * half_b - c[2] * c[0];
    if (!(discriminant > 0.0)) return roots;
    const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    double first = q / c[2], second = c[0] / q;  // an infinite one is outside
    if (first > second) std::swap(first, second);
    for (const double root : {first, second}) {
        if (root >= low && root <= high) roots.push_back(root);
    }
    return roots;
}

}  // namespace

double evaluate(std::span<const double> c, double x) {
    double value = 0.0;
    for (std::size_t i = c.size(); i-- > 0;) value = value * x + c[i];
    return value;
}

double root_in_bracket(std::span<const double> c, double low, double high, bool rising) {
    double x = 0.5 * (low + high);
    for (int i = 0; i < 100; ++i) {
        const auto [value, slope] = evaluate_with_slope(c, x);
        if (value == 0.0) return x;
        ((value < 0.0) == rising ? low : high) = x;
        // Newton's step, unless it leaves the bracket; then halve that.
        double next = x - value / slope;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (next == x || next <= low || next >= high) return next;
        const double step = std::fabs(next - x);
        x = next;
        if (step <= 0x1p-52 * std::fabs(x)) return x;
    }
    return x;
}

Roots roots_between(std::span<const double> c, double low, double high) {
    Roots roots;
    if (c.size() < 2) return roots;
    if (c.size() == 2) {
        const double root = -c[0] / c[1];
        if (root >= low && root <= high) roots.push_back(root);
        return roots;
    }
    if (c.size() == 3) return quadratic_roots(c, low, high);

    std::array<double, 7> derivative;
    for (std::size_t i = 1; i < c.size(); ++i) derivative[i - 1] = static_cast<double>(i) * c[i];
    Roots stops = roots_between({derivative.data(), c.size() - 1}, low, high);
    stops.push_back(high);

    double left = low, value_left = evaluate(c, low);
    for (const double right : stops) {
        const double value_right = evaluate(c, right);
        if ((value_left < 0.0) != (value_right < 0.0)) {
            roots.push_back(root_in_bracket(c, left, right, value_left < 0.0));
        }
        left = right;
        value_left = value_right;
    }
    return roots;
}

}  // namespace meniscus::geom
