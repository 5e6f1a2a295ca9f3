#include "tracer/adaptive.hpp"

#include <algorithm>

namespace meniscus::tracer {
namespace {

/// What twice the samples leave of a squared error: errors of Owen-scrambled Sobol points fall as
/// n^-0.7 in pictures of glass.
constexpr double left_by_doubling = 0.38;

}  // namespace

std::vector<bool> choose_pixels(std::span<const PixelNeed> pixels, double allowed) {
    struct Place {
        double worth;
        std::size_t pixel;
    };
    std::vector<Place> order;
    order.reserve(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        order.push_back({pixels[i].squared_error / pixels[i].cost, i});
    std::ranges::sort(order, [](const Place& a, const Place& b) {
        return a.worth != b.worth ? a.worth > b.worth : a.pixel < b.pixel;
    });

    double sum = 0.0;
    for (const PixelNeed& pixel : pixels) sum += pixel.squared_error;
    std::vector<bool> chosen(pixels.size(), false);
    for (const auto& [worth, i] : order) {
        if (sum <= allowed || pixels[i].squared_error <= 0.0) break;
        if (!pixels[i].may_grow) continue;
        chosen[i] = true;
        sum -= (1.0 - left_by_doubling) * pixels[i].squared_error;
    }
    return chosen;
}

}  // namespace meniscus::tracer
