#pragma once

#include "compare/comparison.hpp"

namespace meniscus::compare {

/// picture - reference of the channel that differs most; infinite where one of them is no number.
double signed_error(const Comparison& comparison, std::size_t pixel);

/// The scale that shows a comparison well: one hundredth of the pixels, at most, lie beyond it. A
/// power of ten times 1, 2 or 5.
double suggested_scale(const Comparison& comparison);

/// The signed differences in the colours of `diverging_color`, white where there is none, the ends
/// of the scale at -scale and +scale. As linear light, to be saved as sRGB.
image::Image difference_map(const Comparison& comparison, double scale);

/// picture - reference as it is, for OpenEXR.
image::Image difference_values(const Comparison& comparison);

}  // namespace meniscus::compare
