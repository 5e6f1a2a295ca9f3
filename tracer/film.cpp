#include "tracer/film.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace meniscus::tracer {
namespace {

/// One plane of an extra image layer.
struct Channel {
    std::string_view name;  // "N.X": of layer N
    double (*value)(const Pixel& pixel, const FirstHit& hit);

    std::string_view layer() const { return name.substr(0, name.find('.')); }
};

// To add a layer: write its channels here, side by side.
constexpr auto channels = std::to_array<Channel>({
    {"N.X", [](const Pixel&, const FirstHit& hit) { return hit.normal.x; }},
    {"N.Y", [](const Pixel&, const FirstHit& hit) { return hit.normal.y; }},
    {"N.Z", [](const Pixel&, const FirstHit& hit) { return hit.normal.z; }},
    {"Variance.Y", [](const Pixel& pixel, const FirstHit&) { return pixel.squared_error(); }},
    {"depth.Z", [](const Pixel&, const FirstHit& hit) { return hit.distance; }},
    {"medium.ID", [](const Pixel&, const FirstHit& hit) { return double(hit.medium); }},
    {"object.ID", [](const Pixel&, const FirstHit& hit) { return double(hit.object); }},
    {"samples.N", [](const Pixel& pixel, const FirstHit&) { return double(pixel.samples); }},
});

}  // namespace

void Pixel::add(const scene::Rgb& light, double weight) {
    add_half(samples % 2 == 1, weight * light, weight, 1);
}

void Pixel::add_half(bool to_odd, const scene::Rgb& light, double weight, int count) {
    (to_odd ? odd : even) += light;
    (to_odd ? odd_weight : even_weight) += weight;
    samples += count;
}

scene::Rgb Pixel::mean() const {
    const double weight = even_weight + odd_weight;
    return weight != 0.0 ? (even + odd) / weight : scene::Rgb{0.0};
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
      pixels_(std::size_t(region_.x1 - region_.x0) * std::size_t(region_.y1 - region_.y0)),
      first_hits_(options.layers ? pixels_.size() : 0) {}

std::vector<double> Film::squared_errors() const {
    std::vector<double> result;
    result.reserve(pixels_.size());
    for (int y = region_.y0; y < region_.y1; ++y) {
        for (int x = region_.x0; x < region_.x1; ++x) {
            double sum = at(x, y).squared_error(), weight = 1.0;
            for (int v = std::max(y - 2, region_.y0); v < std::min(y + 3, region_.y1); ++v) {
                for (int u = std::max(x - 2, region_.x0); u < std::min(x + 3, region_.x1); ++u) {
                    sum += at(u, v).squared_error();
                    weight += 1.0;
                }
            }
            result.push_back(sum / weight);
        }
    }
    return result;
}

std::vector<std::string> layer_names() {
    std::vector<std::string> names;
    for (const Channel& channel : channels) {
        const std::string name(channel.layer());
        if (names.empty() || names.back() != name) names.push_back(name);
    }
    return names;
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
    for (const Channel& channel : channels) {
        image::Layer layer{std::string(channel.name), {}};
        layer.values.reserve(pixels_.size());
        for (std::size_t i = 0; i < pixels_.size(); ++i)
            layer.values.push_back(float(channel.value(pixels_[i], first_hits_[i])));
        picture.layers.push_back(std::move(layer));
    }
    return picture;
}

}  // namespace meniscus::tracer
