#include "tracer/adaptive.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace meniscus::tracer {
namespace {

/// What twice the samples leave of a squared error: errors of Owen-scrambled Sobol points fall as
/// n^-0.7 in pictures of glass.
constexpr double left_by_doubling = 0.38;

}  // namespace

std::vector<bool> choose_pixels(std::span<const PixelNeed> pixels, double allowed) {
    std::vector<std::size_t> order(pixels.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<double> worth;
    worth.reserve(pixels.size());
    for (const PixelNeed& pixel : pixels) worth.push_back(pixel.squared_error / pixel.cost);
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](auto i) { return worth[i]; });

    double sum = 0.0;
    for (const PixelNeed& pixel : pixels) sum += pixel.squared_error;
    std::vector<bool> chosen(pixels.size(), false);
    for (const std::size_t i : order) {
        if (sum <= allowed || pixels[i].squared_error <= 0.0) break;
        if (!pixels[i].may_grow) continue;
        chosen[i] = true;
        sum -= (1.0 - left_by_doubling) * pixels[i].squared_error;
    }
    return chosen;
}

}  // namespace meniscus::tracer
