#include "tracer/pixel_samples.hpp"

#include "tracer/sampler.hpp"

namespace meniscus::tracer {

Sample PixelSamples::at(int x, int y, double u, double v, std::uint64_t number) const {
    const std::uint64_t pixel = std::uint64_t(y) * 0x100000000ull + std::uint64_t(x);
    return {.x = x + u, .y = y + v, .key = mix(mix(mix(seed_) + pixel) + number)};
}

void PixelSamples::add_grid(int x, int y, int k, std::vector<Sample>& out) const {
    for (int j = 0; j < k; ++j) {
        for (int i = 0; i < k; ++i)
            out.push_back(at(x, y, (i + 0.5) / k, (j + 0.5) / k, std::uint64_t(j) * k + i));
    }
}

void PixelSamples::add_trapezoid(int x, int y, int n, std::vector<Sample>& out) const {
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            out.push_back(at(x, y, double(i) / n, double(j) / n, std::uint64_t(j) * (n + 1) + i));
            out.back().weight = (i % n == 0 ? 0.5 : 1.0) * (j % n == 0 ? 0.5 : 1.0);
        }
    }
}

void PixelSamples::add_points(int x, int y, int from, int to, std::vector<Sample>& out,
                              int sets) const {
    const std::uint64_t seed =
        mix(mix(seed_ ^ 0x5eed) + (std::uint64_t(y) << 32) + std::uint64_t(x));
    for (int index = from; index < to; ++index) {
        const int set = index % sets;
        const FilterSampler::Point point = filter_.point(sobol_point(
            std::uint32_t(index / sets), set == 0 ? seed : mix(seed + std::uint64_t(set))));
        out.push_back(at(x, y, point.at.x, point.at.y, std::uint64_t(index)));
        out.back().weight = point.weight;
    }
}

}  // namespace meniscus::tracer
