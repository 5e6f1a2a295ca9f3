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

/// On reversed words: a random permutation that keeps elementary intervals, since each bit is
/// flipped depending on the bits below it only (Laine and Karras 2011; constants by Vegdahl 2021).
std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// The second Sobol dimension, reversed. Its direction numbers, of the polynomial x + 1, are the
/// rows of Pascal's triangle modulo 2: bit j is the sum of the index' bits i with i & j == j.
std::uint32_t sobol_second_reversed(std::uint32_t index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    return index ^ (index >> 16);
}

}  // namespace

SobolSet::SobolSet(std::uint64_t seed) {
    const std::uint64_t a = mix(seed), b = mix(seed + 0x632be59bd9b4e019ull);
    order_ = std::uint32_t(a);
    first_ = std::uint32_t(a >> 32);
    second_ = std::uint32_t(b);
}

geom::Vec2 SobolSet::point(std::uint32_t index) const {
    const std::uint32_t shuffled = reverse_bits(scramble_reversed(reverse_bits(index), order_));
    // The first dimension is the reversed index.
    const std::uint32_t x = reverse_bits(scramble_reversed(shuffled, first_));
    const std::uint32_t y =
        reverse_bits(scramble_reversed(sobol_second_reversed(shuffled), second_));
    return {double(x) * 0x1p-32, double(y) * 0x1p-32};
}

}  // namespace meniscus::tracer
