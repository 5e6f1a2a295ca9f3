#include "tracer/film.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace meniscus::tracer {
namespace {

/// What there is to tell of a pixel.
struct Gathered {
    Pixel pixel;
    int samples;
    const FirstHit& hit;
};

/// One plane of an extra image layer.
struct Channel {
    std::string_view name;  // "N.X": of layer N
    double (*value)(const Gathered& of);

    std::string_view layer() const { return name.substr(0, name.find('.')); }
};

// To add a layer: write its channels here, side by side.
constexpr auto channels = std::to_array<Channel>({
    {"N.X", [](const Gathered& of) { return of.hit.normal.x; }},
    {"N.Y", [](const Gathered& of) { return of.hit.normal.y; }},
    {"N.Z", [](const Gathered& of) { return of.hit.normal.z; }},
    {"Variance.Y", [](const Gathered& of) { return of.pixel.squared_error(); }},
    {"depth.Z", [](const Gathered& of) { return of.hit.distance; }},
    {"medium.ID", [](const Gathered& of) { return double(of.hit.medium); }},
    {"object.ID", [](const Gathered& of) { return double(of.hit.object); }},
    {"samples.N", [](const Gathered& of) { return double(of.samples); }},
});

}  // namespace

scene::Rgb Pixel::mean() const {
    const double weight = even.weight + odd.weight;
    return weight != 0.0 ? (even.light() + odd.light()) / weight : scene::Rgb{0.0};
}

double Pixel::squared_error() const {
    if (even.weight == 0.0 || odd.weight == 0.0) return 0.0;
    const scene::Rgb half = 0.5 * (even.light() / even.weight - odd.light() / odd.weight);
    return glm::dot(half, half) / 3.0;
}

Film::Film(const Options& options)
    : full_width_(options.width),
      full_height_(options.height),
      region_(options.region.value_or(Region{0, 0, options.width, options.height})),
      memory_(pixel_count() * (2 * sizeof(HalfPixel) + sizeof(Tally))),
      even_(memory_.array<HalfPixel>(0)),
      tallies_(memory_.array<Tally>(pixel_count() * sizeof(HalfPixel))),
      odd_(memory_.array<HalfPixel>(pixel_count() * (sizeof(HalfPixel) + sizeof(Tally)))),
      first_hits_(options.layers ? pixel_count() : 0) {}

void Film::add(std::size_t pixel, const scene::Rgb& light, double weight) {
    Tally& tally = tallies_[pixel];
    HalfPixel& to = half(pixel, tally.samples % 2 == 1);
    to.add(weight * light);
    to.weight += weight;
    ++tally.samples;
}

void Film::clear(std::size_t pixel) {
    even_[pixel] = odd_[pixel] = {};
    tallies_[pixel] = {};
}

std::uint64_t Film::samples() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < pixel_count(); ++i) sum += std::uint64_t(tallies_[i].samples);
    return sum;
}

std::vector<double> Film::squared_errors() const {
    std::vector<double> own, result;
    own.reserve(pixel_count());
    result.reserve(pixel_count());
    for (std::size_t i = 0; i < pixel_count(); ++i) own.push_back(pixel(i).squared_error());
    for (int y = 0; y < height(); ++y) {
        for (int x = 0; x < width(); ++x) {
            const auto at = [&](int u, int v) {
                return std::size_t(v) * std::size_t(width()) + std::size_t(u);
            };
            double sum = own[at(x, y)], weight = 1.0;
            for (int v = std::max(y - 2, 0); v < std::min(y + 3, height()); ++v) {
                for (int u = std::max(x - 2, 0); u < std::min(x + 3, width()); ++u) {
                    sum += own[at(u, v)];
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
    for (std::size_t i = 0; i < pixel_count(); ++i) {
        const scene::Rgb mean = pixel(i).mean();
        for (int c = 0; c < 3; ++c) picture.rgb[3 * i + c] = float(mean[c]);
    }
    if (!layers) return picture;
    for (const Channel& channel : channels) {
        image::Layer layer{std::string(channel.name), {}};
        layer.values.reserve(pixel_count());
        for (std::size_t i = 0; i < pixel_count(); ++i)
            layer.values.push_back(
                float(channel.value({pixel(i), tallies_[i].samples, first_hits_[i]})));
        picture.layers.push_back(std::move(layer));
    }
    return picture;
}

}  // namespace meniscus::tracer
