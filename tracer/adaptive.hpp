#pragma once

#include <span>
#include <vector>

namespace meniscus::tracer {

/// What is known of a pixel that may get more samples.
struct PixelNeed {
    double squared_error;  // of its mean, as estimated
    double cost;           // of all its samples so far, in any unit
    bool may_grow = true;
};

/// Which pixels get twice the samples: those that take most off the sum of squared errors for what
/// they cost, just as many as bring it to `allowed` by what is to be expected; all that have an
/// error if that is not enough. Done again and again, this gives a pixel of variance v and cost c
/// (v / c)^(1 / (1 + 2r)) samples where errors fall as n^-r, which is the cheapest way to an error.
std::vector<bool> choose_pixels(std::span<const PixelNeed> pixels, double allowed);

}  // namespace meniscus::tracer
