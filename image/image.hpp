#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace meniscus::image {

/// A named plane of values beside the colours: "depth.Z", "Variance.R". One float a pixel, rows
/// from the top.
struct Layer {
    std::string name;
    std::vector<float> values;
};

/// A finished picture: linear red, green, blue, three floats a pixel, rows from the top. It may be
/// a window of a larger picture.
struct Image {
    int width = 0, height = 0;  // of the window
    int x0 = 0, y0 = 0;         // the window's place in the full picture
    int full_width = 0, full_height = 0;
    std::vector<float> rgb;
    std::vector<Layer> layers;

    Image() = default;
    Image(int w, int h)
        : width(w), height(h), full_width(w), full_height(h), rgb(std::size_t(3) * w * h) {}

    float* pixel(int x, int y) { return rgb.data() + 3 * (std::size_t(y) * width + x); }
    const float* pixel(int x, int y) const { return rgb.data() + 3 * (std::size_t(y) * width + x); }
};

/// Text that travels in the file's header: sorted by key, no time stamps.
using Metadata = std::map<std::string, std::string>;

}  // namespace meniscus::image
