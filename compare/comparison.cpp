#include "compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meniscus::compare {
namespace {

using image::Image;

Image cut(const Image& picture, int x0, int y0, int width, int height) {
    Image result(width, height);
    result.x0 = x0;
    result.y0 = y0;
    result.full_width = picture.full_width;
    result.full_height = picture.full_height;
    for (const auto& layer : picture.layers) result.layers.push_back({layer.name, {}});
    for (int y = 0; y < height; ++y) {
        const std::size_t first =
            std::size_t(y0 + y - picture.y0) * picture.width + std::size_t(x0 - picture.x0);
        std::copy_n(picture.rgb.begin() + std::ptrdiff_t(3 * first), 3 * width, result.pixel(0, y));
        for (std::size_t i = 0; i < picture.layers.size(); ++i) {
            const auto from = picture.layers[i].values.begin() + std::ptrdiff_t(first);
            result.layers[i].values.insert(result.layers[i].values.end(), from, from + width);
        }
    }
    return result;
}

void cut_to_common_window(Side& a, Side& b) {
    Image &p = a.picture, &q = b.picture;
    if (p.full_width != q.full_width || p.full_height != q.full_height)
        throw Mismatch(
            fmt::format("{} is {} x {} pixels and {} is {} x {}: pictures to compare "
                        "must be of one size",
                        a.name, p.full_width, p.full_height, b.name, q.full_width, q.full_height));
    const int x0 = std::max(p.x0, q.x0), y0 = std::max(p.y0, q.y0);
    const int width = std::min(p.x0 + p.width, q.x0 + q.width) - x0;
    const int height = std::min(p.y0 + p.height, q.y0 + q.height) - y0;
    if (width < 1 || height < 1)
        throw Mismatch(
            fmt::format("{} and {} hold different regions of the picture, without a "
                        "pixel in common",
                        a.name, b.name));
    p = cut(p, x0, y0, width, height);
    q = cut(q, x0, y0, width, height);
}

void clip(Image& picture) {
    for (float& value : picture.rgb)
        if (!std::isnan(value)) value = std::clamp(value, 0.0f, 1.0f);
}

Regions find_regions(const Comparison& comparison) {
    for (const auto* side : {&comparison.reference, &comparison.picture}) {
        if (auto regions = regions_by_layers(side->picture)) {
            regions->how = fmt::format("{}, {}", side->name, regions->how);
            return *std::move(regions);
        }
    }
    return regions_by_contrast(comparison.reference.picture);
}

std::string line(std::string_view name, const Metrics& metrics) {
    auto text = fmt::format("{:<14}{:>9}   {:<10.3g}  {:<10.3g}  {:<+10.3g}  {:.3f} % ({})", name,
                            metrics.pixels, metrics.rmse, metrics.largest, metrics.bias,
                            100.0 * metrics.share_off(), metrics.off);
    if (metrics.not_finite > 0)
        text += fmt::format(", of them {} without a finite value", metrics.not_finite);
    return text + '\n';
}

}  // namespace

Comparison compare(Side reference, Side picture, const Settings& settings,
                   std::optional<Regions> regions) {
    Comparison result{.reference = std::move(reference),
                      .picture = std::move(picture),
                      .settings = settings,
                      .all = {},
                      .regions = {},
                      .by_region = {},
                      .worst = {},
                      .errors = {}};
    cut_to_common_window(result.reference, result.picture);
    Image &a = result.reference.picture, &b = result.picture.picture;
    if (settings.clip) {
        clip(a);
        clip(b);
    }
    result.regions = regions ? *std::move(regions) : find_regions(result);
    result.errors = pixel_errors(a, b);
    result.all = measure(a, b, settings.threshold);
    for (const auto& region : result.regions.parts)
        result.by_region.push_back(measure(a, b, settings.threshold, &region.pixels));
    for (const auto pixel : worst_pixels(result.errors, a.width, settings.worst))
        result.worst.push_back({a.x0 + int(pixel % std::size_t(a.width)),
                                a.y0 + int(pixel / std::size_t(a.width)), result.errors[pixel]});
    return result;
}

std::string format_text(const Comparison& comparison) {
    auto text = fmt::format("reference      {}\npicture        {}\n", comparison.reference.name,
                            comparison.picture.name);
    for (const auto* side : {&comparison.reference, &comparison.picture})
        for (const auto& [name, value] : side->facts)
            text += fmt::format("{:<15}{}: {}\n", "", side->name, name + " " + value);
    text += fmt::format("values         linear light{}\n\n",
                        comparison.settings.clip ? ", clipped to [0, 1]" : "");
    text += fmt::format("{:<14}{:>9}   {:<10}  {:<10}  {:<10}  off by more than {:g}\n", "",
                        "pixels", "RMSE", "largest", "bias", comparison.settings.threshold);
    text += line("all", comparison.all);
    for (std::size_t i = 0; i < comparison.by_region.size(); ++i)
        text += line(comparison.regions.parts[i].name, comparison.by_region[i]);
    text += fmt::format("regions        {}\n", comparison.regions.how);
    if (comparison.worst.empty()) return text + "worst pixels   none: the pictures are equal\n";
    text += "worst pixels  ";
    for (const auto& pixel : comparison.worst)
        text += fmt::format(" ({}, {}) {:.3g}{}", pixel.x, pixel.y, pixel.error,
                            &pixel == &comparison.worst.back() ? "\n" : ",");
    return text;
}

}  // namespace meniscus::compare
