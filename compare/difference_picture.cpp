#include "compare/difference_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/color_scale.hpp"
#include "image/color.hpp"

namespace meniscus::compare {

double signed_error(const Comparison& comparison, std::size_t pixel) {
    double result = 0.0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
        const double d =
            double(comparison.picture.picture.rgb[i]) - double(comparison.reference.picture.rgb[i]);
        if (std::isfinite(d) && std::abs(d) > std::abs(result)) result = d;
    }
    return std::isfinite(comparison.errors[pixel]) ? result
                                                   : std::numeric_limits<double>::quiet_NaN();
}

double suggested_scale(const Comparison& comparison) {
    auto errors = comparison.errors;
    std::erase_if(errors, [](double error) { return !std::isfinite(error) || error == 0.0; });
    if (errors.empty()) return 1.0;
    const auto rank = errors.begin() + std::ptrdiff_t(0.99 * double(errors.size() - 1));
    std::ranges::nth_element(errors, rank);
    const double power = std::pow(10.0, std::floor(std::log10(*rank)));
    for (const double step : {1.0, 2.0, 5.0})
        if (*rank <= step * power) return step * power;
    return 10.0 * power;
}

image::Image difference_map(const Comparison& comparison, double scale) {
    image::Image map(comparison.width(), comparison.height());
    for (std::size_t pixel = 0; pixel < comparison.errors.size(); ++pixel) {
        const auto color = diverging_color(signed_error(comparison, pixel) / scale);
        for (std::size_t c = 0; c < 3; ++c)
            map.rgb[3 * pixel + c] = float(image::srgb_decode(color[c]));
    }
    return map;
}

image::Image difference_values(const Comparison& comparison) {
    image::Image values = comparison.reference.picture;
    values.layers.clear();
    for (std::size_t i = 0; i < values.rgb.size(); ++i)
        values.rgb[i] = comparison.picture.picture.rgb[i] - values.rgb[i];
    return values;
}

}  // namespace meniscus::compare
