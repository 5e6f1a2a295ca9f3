#pragma once

#include <string>
#include <vector>

#include "geom/huge_pages.hpp"
#include "image/image.hpp"
#include "scene/color.hpp"
#include "tracer/options.hpp"
#include "tracer/ray_tree.hpp"

namespace meniscus::tracer {

/// What a pixel has gathered. Samples go to two halves in turn, whose difference tells the error.
struct Pixel {
    scene::Rgb even{0.0}, odd{0.0};
    double even_weight = 0.0, odd_weight = 0.0;
    int samples = 0;
    double cost = 0.0;  // of its samples: segments, or leaves of their ray trees

    void add(const scene::Rgb& light, double weight = 1.0);
    /// The sum of several samples that belong to one half.
    void add_half(bool to_odd, const scene::Rgb& light, double weight, int count);
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
    Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
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
    int full_width_, full_height_;
    Region region_;
    geom::HugeVector<Pixel> pixels_;
    std::vector<FirstHit> first_hits_;
};

}  // namespace meniscus::tracer
