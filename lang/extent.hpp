#pragma once

#include <fmt/format.h>

#include <string_view>

#include "lang/diagnostic.hpp"

namespace meniscus::lang {

/// Squares of coordinates, and products of these, must still be numbers; the hierarchy of bounds
/// holds them in single precision.
inline constexpr double largest_coordinate = 1e30;

/// Throws unless all coordinates of what stands at `span` are at most `extent`, and that within
/// reason. Not a number is too large.
inline void check_extent(double extent, std::string_view what, const Span& span) {
    if (extent <= largest_coordinate) return;
    throw SourceError(span, fmt::format("{} has coordinates beyond {:g}: too large to be traced",
                                        what, largest_coordinate));
}

}  // namespace meniscus::lang
