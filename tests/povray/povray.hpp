#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meniscus::test {

/// A picture as POV-Ray made it: linear, clipped to [0, 1], three values a pixel.
struct Reference {
    int width = 0, height = 0;
    std::vector<double> rgb;
};

/// Runs the installed POV-Ray 3.7 on a scene at pixel centres, with 16-bit linear output. Throws
/// with its messages if it fails.
Reference run_povray(const std::filesystem::path& scene, int width, int height);

struct Difference {
    double rmse = 0.0, largest = 0.0;
    double share_off = 0.0;  // of pixels off by more than 0.02
    int worst_x = 0, worst_y = 0;
    std::string text() const;
};

/// The `outliers` worst pixels are left out of `rmse`, and of nothing else.
Difference difference(const Reference& reference, const std::vector<float>& rgb,
                      std::size_t outliers = 0);

}  // namespace meniscus::test
