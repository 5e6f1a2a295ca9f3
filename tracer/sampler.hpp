#pragma once

#include <cstdint>

#include "geom/vec.hpp"

namespace meniscus::tracer {

/// Mixes 64 bits well (the finaliser of SplitMix64, Steele et al. 2014).
inline std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// Random numbers in [0, 1) that are a function of where they start, whatever thread asks.
class RandomStream {
public:
    explicit RandomStream(std::uint64_t start) : state_(start) {}
    double next() { return double(mix(state_++) >> 11) * 0x1p-53; }

private:
    std::uint64_t state_;
};

/// Point `index` of an Owen-scrambled Sobol set in [0, 1)^2, a function of index and seed only
/// (Burley 2020).
geom::Vec2 sobol_point(std::uint32_t index, std::uint64_t seed);

}  // namespace meniscus::tracer
