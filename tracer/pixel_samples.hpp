#pragma once

#include <vector>

#include "tracer/film.hpp"
#include "tracer/options.hpp"
#include "tracer/pixel_filter.hpp"
#include "tracer/samples.hpp"

namespace meniscus::tracer {

/// Where in a pixel its samples lie, and with what weights: a function of pixel, number and seed
/// only.
class PixelSamples {
public:
    explicit PixelSamples(const Options& options);

    /// k x k midpoints.
    void add_grid(int x, int y, int k, std::vector<Sample>& out) const;
    /// (n + 1) x (n + 1) points from corner to corner, those of the edges and corners with a half
    /// and a quarter of the weight.
    void add_trapezoid(int x, int y, int n, std::vector<Sample>& out) const;
    /// Those from number `from` to `to` of the pixel's own low-discrepancy set, or of two that know
    /// nothing of each other and take turns.
    void add_points(int x, int y, int from, int to, std::vector<Sample>& out,
                    bool in_two_sets = false) const;

private:
    /// Of sample 0 of a pixel, before it is mixed.
    std::uint64_t first_key(int x, int y) const;

    std::uint64_t seed_, mixed_seed_;
    FilterSampler filter_;
};

}  // namespace meniscus::tracer
