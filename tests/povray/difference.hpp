#pragma once

#include <cstddef>
#include <string>

#include "image/image.hpp"

namespace meniscus::test {

struct Difference {
    double rmse = 0.0, largest = 0.0;
    double share_off = 0.0;  // of pixels off by more than 0.02
    int worst_x = 0, worst_y = 0;
    std::string text() const;
};

/// Of our picture, clipped to [0, 1], from POV-Ray's. The `outliers` worst pixels are left out of
/// `rmse`, and of nothing else.
Difference difference(const image::Image& reference, const image::Image& ours,
                      std::size_t outliers = 0);

}  // namespace meniscus::test
