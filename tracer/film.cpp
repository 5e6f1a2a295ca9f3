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
    const auto columns = std::size_t(width()), rows = std::size_t(height());
    std::vector<double> own, result;
    own.reserve(pixel_count());
    result.reserve(pixel_count());
    for (std::size_t i = 0; i < pixel_count(); ++i) own.push_back(pixel(i).squared_error());
    std::vector<double> sums(columns);  // of the neighbours above and below
    for (std::size_t y = 0; y < rows; ++y) {
        const std::size_t v0 = y - std::min<std::size_t>(y, 2), v1 = std::min(y + 3, rows);
        std::ranges::fill(sums, 0.0);
        for (std::size_t v = v0; v < v1; ++v)
            for (std::size_t x = 0; x < columns; ++x) sums[x] += own[v * columns + x];
        for (std::size_t x = 0; x < columns; ++x) {
            const std::size_t u0 = x - std::min<std::size_t>(x, 2), u1 = std::min(x + 3, columns);
            double sum = own[y * columns + x];
            for (std::size_t u = u0; u < u1; ++u) sum += sums[u];
            result.push_back(sum / double(1 + (v1 - v0) * (u1 - u0)));
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
