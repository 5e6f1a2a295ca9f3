#pragma once

#include <span>

#include "geom/inline_vector.hpp"

namespace meniscus::geom {

using Roots = InlineVector<double, 8>;

/// The value of c[0] + c[1] x + c[2] x^2 + ...
double evaluate(std::span<const double> coefficients, double x);

/// Where the polynomial changes its sign between `low` and `high`, sorted. Between two neighbouring
/// extremes it is monotonic, so each root is found in a bracket that holds just one; the extremes
/// are roots of the derivative. At most degree 7.
Roots roots_between(std::span<const double> coefficients, double low, double high);

/// The root in a bracket across which the polynomial rises (or else falls) through 0.
double root_in_bracket(std::span<const double> coefficients, double low, double high, bool rising);

}  // namespace meniscus::geom
