#pragma once

#include <cstddef>
#include <vector>

#include "image/image.hpp"

namespace meniscus::compare {

/// How far a picture is from a reference, over linear red, green and blue.
struct Metrics {
    std::size_t pixels = 0;
    double rmse = 0.0;           // root of the mean square difference, over pixels and channels
    double bias = 0.0;           // mean of picture - reference
    double largest = 0.0;        // of all channels' absolute differences
    std::size_t off = 0;         // pixels with a channel off by more than the threshold
    std::size_t not_finite = 0;  // pixels with a channel that is no number in one picture only;
                                 // they count as off, and in no other figure
    double share_off() const { return pixels == 0 ? 0.0 : double(off) / double(pixels); }
};

/// A pixel's largest absolute difference over its channels; infinite where a value is no finite
/// number and the other picture's is another. Pictures must be of one size.
std::vector<double> pixel_errors(const image::Image& reference, const image::Image& picture);

/// Over all pixels, or over those where `chosen` says so.
Metrics measure(const image::Image& reference, const image::Image& picture, double threshold,
                const std::vector<bool>* chosen = nullptr);

/// The indices of the `count` worst pixels, the worst first, no two of them neighbours.
std::vector<std::size_t> worst_pixels(const std::vector<double>& errors, int width,
                                      std::size_t count);

}  // namespace meniscus::compare
