#pragma once

#include <cstddef>
#include <string>

#include "image/image.hpp"

namespace meniscus::test {

struct Difference {
    double rmse = 0.0, largest = 0.0;
    double share_off = 0.0;  // of pixels off by more than 0.02, if not said otherwise
    int worst_x = 0, worst_y = 0;
    std::string text() const;
};

/// Of our picture, clipped to [0, 1], from POV-Ray's. The `outliers` worst pixels are left out of
/// `rmse`, and of nothing else.
Difference difference(const image::Image& reference, const image::Image& ours,
                      std::size_t outliers = 0);

/// The same, with `rmse` over the pixels that are at least one pixel away from the discontinuities
/// of our picture (neighbours more than 0.04 apart), and `share_off` the share of all pixels off by
/// more than 0.01.
Difference difference_off_edges(const image::Image& reference, const image::Image& ours);

}  // namespace meniscus::test
