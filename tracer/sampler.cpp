#include "tracer/sampler.hpp"

namespace meniscus::tracer {
namespace {

std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
    x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
    return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

/// A random permutation that keeps elementary intervals: each bit is flipped depending on the bits
/// above it only, seen from the reversed word (Laine and Karras 2011; constants by Vegdahl 2021).
std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse_bits(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverse_bits(x);
}

/// The second Sobol dimension: direction numbers of the polynomial x + 1.
std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t v = 1u << 31; index; index >>= 1, v ^= v >> 1) {
        if (index & 1u) result ^= v;
    }
    return result;
}

}  // namespace

geom::Vec2 sobol_point(std::uint32_t index, std::uint64_t seed) {
    const std::uint64_t a = mix(seed), b = mix(seed + 0x632be59bd9b4e019ull);
    const std::uint32_t shuffled = owen_scramble(index, std::uint32_t(a));
    const std::uint32_t x = owen_scramble(reverse_bits(shuffled), std::uint32_t(a >> 32));
    const std::uint32_t y = owen_scramble(sobol_second(shuffled), std::uint32_t(b));
    return {double(x) * 0x1p-32, double(y) * 0x1p-32};
}

}  // namespace meniscus::tracer
