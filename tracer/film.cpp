#include "tracer/film.hpp"

#include <algorithm>

namespace meniscus::tracer {

void Pixel::add(const scene::Rgb& light, double weight) {
    if (samples++ % 2 == 0) {
        even += weight * light;
        even_weight += weight;
    } else {
        odd += weight * light;
        odd_weight += weight;
    }
}

scene::Rgb Pixel::mean() const {
    const double weight = even_weight + odd_weight;
    return weight > 0.0 ? (even + odd) / weight : scene::Rgb{0.0};
}

double Pixel::squared_error() const {
    if (even_weight == 0.0 || odd_weight == 0.0) return 0.0;
    const scene::Rgb half = 0.5 * (even / even_weight - odd / odd_weight);
    return glm::dot(half, half) / 3.0;
}

Film::Film(const Options& options)
    : full_width_(options.width),
      full_height_(options.height),
      region_(options.region.value_or(Region{0, 0, options.width, options.height})),
      pixels_(std::size_t(region_.x1 - region_.x0) * std::size_t(region_.y1 - region_.y0)) {}

std::vector<double> Film::squared_errors() const {
    std::vector<double> result;
    result.reserve(pixels_.size());
    for (int y = region_.y0; y < region_.y1; ++y) {
        for (int x = region_.x0; x < region_.x1; ++x) {
            double sum = at(x, y).squared_error(), weight = 1.0;
            for (int v = std::max(y - 1, region_.y0); v < std::min(y + 2, region_.y1); ++v) {
                for (int u = std::max(x - 1, region_.x0); u < std::min(x + 2, region_.x1); ++u) {
                    sum += at(u, v).squared_error();
                    weight += 1.0;
                }
            }
            result.push_back(sum / weight);
        }
    }
    return result;
}

image::Image Film::develop(bool layers) const {
    image::Image picture(width(), height());
    picture.x0 = region_.x0;
    picture.y0 = region_.y0;
    picture.full_width = full_width_;
    picture.full_height = full_height_;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const scene::Rgb mean = pixels_[i].mean();
        for (int c = 0; c < 3; ++c) picture.rgb[3 * i + c] = float(mean[c]);
    }
    if (!layers) return picture;
    const auto add_layer = [&](const char* name, auto&& value_of) {
        image::Layer layer{name, {}};
        layer.values.reserve(pixels_.size());
        for (const Pixel& pixel : pixels_) layer.values.push_back(float(value_of(pixel)));
        picture.layers.push_back(std::move(layer));
    };
    add_layer("N.X", [](const Pixel& pixel) { return pixel.first_hit.normal.x; });
    add_layer("N.Y", [](const Pixel& pixel) { return pixel.first_hit.normal.y; });
    add_layer("N.Z", [](const Pixel& pixel) { return pixel.first_hit.normal.z; });
    add_layer("Variance.Y", [](const Pixel& pixel) { return pixel.squared_error(); });
    add_layer("depth.Z", [](const Pixel& pixel) { return pixel.first_hit.distance; });
    add_layer("object.ID", [](const Pixel& pixel) { return pixel.first_hit.object; });
    add_layer("samples.N", [](const Pixel& pixel) { return pixel.samples; });
    return picture;
}

}  // namespace meniscus::tracer
