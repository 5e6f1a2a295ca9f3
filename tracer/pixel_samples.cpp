#include "tracer/pixel_samples.hpp"

#include "tracer/sampler.hpp"

namespace meniscus::tracer {

PixelSamples::PixelSamples(const Options& options)
    : seed_(options.seed), mixed_seed_(mix(options.seed)), filter_(options.filter) {}

std::uint64_t PixelSamples::first_key(int x, int y) const {
    return mix(mixed_seed_ + std::uint64_t(y) * 0x100000000ull + std::uint64_t(x));
}

void PixelSamples::add_grid(int x, int y, int k, std::vector<Sample>& out) const {
    std::uint64_t key = first_key(x, y);
    for (int j = 0; j < k; ++j) {
        for (int i = 0; i < k; ++i)
            out.push_back({.x = x + (i + 0.5) / k, .y = y + (j + 0.5) / k, .key = mix(key++)});
    }
}

void PixelSamples::add_trapezoid(int x, int y, int n, std::vector<Sample>& out) const {
    std::uint64_t key = first_key(x, y);
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double weight = (i % n == 0 ? 0.5 : 1.0) * (j % n == 0 ? 0.5 : 1.0);
            out.push_back({.x = x + double(i) / n,
                           .y = y + double(j) / n,
                           .weight = weight,
                           .key = mix(key++)});
        }
    }
}

void PixelSamples::add_points(int x, int y, int from, int to, std::vector<Sample>& out,
                              bool in_two_sets) const {
    const std::uint64_t seed =
        mix(mix(seed_ ^ 0x5eed) + (std::uint64_t(y) << 32) + std::uint64_t(x));
    const std::uint64_t key = first_key(x, y);
    const auto add = [&](const SobolSet& set, int number, int index) {
        const FilterSampler::Point point = filter_.point(set.point(std::uint32_t(number)));
        out.push_back({.x = x + point.at.x,
                       .y = y + point.at.y,
                       .weight = point.weight,
                       .key = mix(key + std::uint64_t(index))});
    };
    const SobolSet first(seed);
    if (!in_two_sets) {
        for (int index = from; index < to; ++index) add(first, index, index);
        return;
    }
    const SobolSet second(mix(seed + 1));
    for (int index = from; index < to; ++index)
        add(index % 2 == 0 ? first : second, index / 2, index);
}

}  // namespace meniscus::tracer
