#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geom/zero_pages.hpp"
#include "image/image.hpp"
#include "scene/color.hpp"
#include "tracer/options.hpp"
#include "tracer/ray_tree.hpp"

namespace meniscus::tracer {

/// What every other sample of a pixel has gathered.
struct HalfPixel {
    double red = 0.0, green = 0.0, blue = 0.0, weight = 0.0;

    scene::Rgb light() const { return {red, green, blue}; }
    void add(const scene::Rgb& light) {
        red += light.r;
        green += light.g;
        blue += light.b;
    }
};

/// How many samples a pixel has and what they cost: segments, or leaves of their ray trees.
struct Tally {
    double cost = 0.0;
    int samples = 0;
};

/// What a pixel has gathered. Samples go to two halves in turn, whose difference tells the error.
struct Pixel {
    HalfPixel even, odd;

    scene::Rgb mean() const;
    /// Squared standard error of the mean, averaged over the channels, as the two halves show it.
    double squared_error() const;
};

/// What the extra image layers are called: "depth" stands for the channel "depth.Z", "N" for the
/// three of the normal.
std::vector<std::string> layer_names();

/// The window of a picture that is being rendered.
class Film {
public:
    Film(const Options& options);

    Region region() const { return region_; }
    int width() const { return region_.x1 - region_.x0; }
    int height() const { return region_.y1 - region_.y0; }
    /// Of pixel (x, y) among those of the window, row by row.
    std::size_t index(int x, int y) const {
        return std::size_t(y - region_.y0) * std::size_t(width()) + std::size_t(x - region_.x0);
    }
    Pixel at(int x, int y) const { return pixel(index(x, y)); }
    const Tally& tally(int x, int y) const { return tallies_[index(x, y)]; }
    Tally& tally(std::size_t pixel) { return tallies_[pixel]; }
    HalfPixel& half(std::size_t pixel, bool is_odd) { return (is_odd ? odd_ : even_)[pixel]; }
    /// One sample more.
    void add(std::size_t pixel, const scene::Rgb& light, double weight);
    void clear(std::size_t pixel);
    std::uint64_t samples() const;
    /// Of the pixel's first sample, if layers are asked for.
    void keep_first_hit(int x, int y, const FirstHit& hit) {
        if (!first_hits_.empty()) first_hits_[index(x, y)] = hit;
    }

    /// Squared errors of all pixels, each the weighted mean of its 5 x 5 neighbours (itself counts
    /// twice): one pixel's two halves say little, and whoever chose pixels by that alone would
    /// leave those with too small an estimate as they are, and call the picture better than it is.
    std::vector<double> squared_errors() const;
    image::Image develop(bool layers) const;

private:
    std::size_t pixel_count() const { return std::size_t(width()) * std::size_t(height()); }
    Pixel pixel(std::size_t i) const {
        return tallies_[i].samples > 1 ? Pixel{even_[i], odd_[i]} : Pixel{even_[i], {}};
    }

    int full_width_, full_height_;
    Region region_;
    // The odd halves last: a picture without anti-aliasing has none.
    geom::ZeroPages memory_;
    HalfPixel* even_;
    Tally* tallies_;
    HalfPixel* odd_;
    std::vector<FirstHit> first_hits_;
};

}  // namespace meniscus::tracer
