#include "tests/povray/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace meniscus::test {
std::string Difference::text() const {
    return fmt::format("rmse {:.2e}, largest {:.2e} at ({}, {}), {:.3f} % of pixels off", rmse,
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

namespace {

double clipped(const image::Image& image, int x, int y, int channel) {
    return std::clamp(double(image.pixel(x, y)[channel]), 0.0, 1.0);
}

double apart(const image::Image& a, int ax, int ay, const image::Image& b, int bx, int by) {
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(clipped(a, ax, ay, c) - clipped(b, bx, by, c)));
    return largest;
}

bool is_near_edge(const image::Image& image, int x, int y) {
    const auto inside = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < image.width && j < image.height;
    };
    for (int j = y - 1; j <= y + 1; ++j) {
        for (int i = x - 1; i <= x + 1; ++i) {
            if (!inside(i, j)) continue;
            if (inside(i + 1, j) && apart(image, i, j, image, i + 1, j) > 0.04) return true;
            if (inside(i, j + 1) && apart(image, i, j, image, i, j + 1) > 0.04) return true;
        }
    }
    return false;
}

}  // namespace

Difference difference_off_edges(const image::Image& reference, const image::Image& ours) {
    Difference result = difference(reference, ours);
    double squares = 0.0;
    std::size_t values = 0, off = 0;
    for (int y = 0; y < ours.height; ++y) {
        for (int x = 0; x < ours.width; ++x) {
            off += apart(reference, x, y, ours, x, y) > 0.01;
            if (is_near_edge(ours, x, y)) continue;
            for (int c = 0; c < 3; ++c) {
                const double d = clipped(reference, x, y, c) - clipped(ours, x, y, c);
                squares += d * d;
                ++values;
            }
        }
    }
    result.rmse = values == 0 ? 0.0 : std::sqrt(squares / double(values));
    result.share_off = double(off) / (double(ours.width) * ours.height);
    return result;
}

}  // namespace meniscus::test
