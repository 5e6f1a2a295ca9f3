#include "compare/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace meniscus::compare {
namespace {

/// picture - reference; two values that are the same infinity or both not a number do not differ.
double difference(float reference, float picture) {
    if (std::isfinite(reference) && std::isfinite(picture))
        return double(picture) - double(reference);
    const bool alike = reference == picture || (std::isnan(reference) && std::isnan(picture));
    return alike ? 0.0 : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<double> pixel_errors(const image::Image& reference, const image::Image& picture) {
    std::vector<double> errors(reference.rgb.size() / 3, 0.0);
    for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
        const double d = std::abs(difference(reference.rgb[i], picture.rgb[i]));
        errors[i / 3] = std::max(errors[i / 3], d);
    }
    return errors;
}

Metrics measure(const image::Image& reference, const image::Image& picture, double threshold,
                const std::vector<bool>* chosen) {
    const auto errors = pixel_errors(reference, picture);
    Metrics result;
    double squares = 0.0, sum = 0.0;
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
        if (chosen && !(*chosen)[pixel]) continue;
        ++result.pixels;
        if (errors[pixel] > threshold) ++result.off;
        if (!std::isfinite(errors[pixel])) {
            ++result.not_finite;
            continue;
        }
        result.largest = std::max(result.largest, errors[pixel]);
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
            const double d = difference(reference.rgb[i], picture.rgb[i]);
            squares += d * d;
            sum += d;
        }
    }
    const double values = 3.0 * double(result.pixels - result.not_finite);
    if (values > 0.0) {
        result.rmse = std::sqrt(squares / values);
        result.bias = sum / values;
    }
    return result;
}

std::vector<std::size_t> worst_pixels(const std::vector<double>& errors, int width,
                                      std::size_t count) {
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](auto a, auto b) { return errors[a] > errors[b]; });

    const auto column = [&](std::size_t pixel) {
        return std::ptrdiff_t(pixel % std::size_t(width));
    };
    const auto row = [&](std::size_t pixel) { return std::ptrdiff_t(pixel / std::size_t(width)); };
    std::vector<std::size_t> worst;
    for (const auto pixel : order) {
        if (worst.size() == count || errors[pixel] == 0.0) break;
        const bool is_neighbour = std::ranges::any_of(worst, [&](std::size_t other) {
            return std::abs(column(other) - column(pixel)) <= 1 &&
                   std::abs(row(other) - row(pixel)) <= 1;
        });
        if (!is_neighbour) worst.push_back(pixel);
    }
    return worst;
}

}  // namespace meniscus::compare
