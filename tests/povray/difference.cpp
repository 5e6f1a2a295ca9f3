#include "tests/povray/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace meniscus::test {
std::string Difference::text() const {
    return fmt::format(
        "rmse {:.2e}, largest {:.2e} at ({}, {}), {:.2f} % of pixels off by more than 0.02", rmse,
        largest, worst_x, worst_y, 100.0 * share_off);
}

Difference difference(const image::Image& reference, const image::Image& ours,
                      std::size_t outliers) {
    const auto& rgb = ours.rgb;
    if (reference.width != ours.width || reference.height != ours.height)
        throw std::runtime_error("pictures of different size");
    struct Pixel {
        double squares = 0.0, worst = 0.0;
        std::size_t index = 0;
    };
    std::vector<Pixel> pixels(rgb.size() / 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i].index = i;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double d =
                std::abs(std::clamp(double(rgb[c]), 0.0, 1.0) - double(reference.rgb[c]));
            pixels[i].squares += d * d;
            pixels[i].worst = std::max(pixels[i].worst, d);
        }
    }
    std::ranges::sort(pixels, std::greater{}, &Pixel::worst);

    Difference result;
    double squares = 0.0;
    for (std::size_t i = outliers; i < pixels.size(); ++i) squares += pixels[i].squares;
    result.rmse = std::sqrt(squares / double(rgb.size()));
    const auto off =
        std::ranges::count_if(pixels, [](const Pixel& pixel) { return pixel.worst > 0.02; });
    result.share_off = double(off) / double(pixels.size());
    result.largest = pixels.front().worst;
    result.worst_x = int(pixels.front().index % std::size_t(reference.width));
    result.worst_y = int(pixels.front().index / std::size_t(reference.width));
    return result;
}

}  // namespace meniscus::test
