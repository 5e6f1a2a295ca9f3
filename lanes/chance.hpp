#pragma once

#include <algorithm>
#include <cstdint>

namespace meniscus::lanes {

// The sampled ray tree. Below this weight one branch is followed by chance instead of both:
inline constexpr double split_above = 0.35;
// and below this a ray survives by chance.
inline constexpr double roulette_below = 0.02;

/// Mixes 64 bits well (the finaliser of SplitMix64, Steele et al. 2014).
inline std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

// Every ray of a tree has a key, a function of its camera ray's and of the branches that lead to
// it; what chance decides about a ray is a function of its key. So no order of work matters.
inline std::uint64_t reflected_key(std::uint64_t key) { return mix(key + 1); }
inline std::uint64_t transmitted_key(std::uint64_t key) { return mix(key + 2); }
/// In [0, 1): which of two branches to follow.
inline double branch_chance(std::uint64_t key) { return double(mix(key + 3) >> 11) * 0x1p-53; }
/// In [0, 1): whether a ray of low weight survives.
inline double survival_chance(std::uint64_t key) { return double(mix(key + 4) >> 11) * 0x1p-53; }
/// In [0, 1): POV-Ray's `crand`.
inline double texture_chance(std::uint64_t key) { return double(mix(key + 5) >> 11) * 0x1p-53; }

/// Which of a surface's two branches a sampled tree follows, and by how much their light grows for
/// the chance that they were not.
struct Branches {
    bool mirror = false, through = false;
    double mirror_gain = 1.0, through_gain = 1.0;
};

/// Both while the weight is high; else one of the two, with the probability of its share: what goes
/// on keeps the sum of their weights.
inline Branches choose(bool mirror, double mirror_share, bool through, double through_share,
                       double weight, std::uint64_t key) {
    Branches result{mirror, through, 1.0, 1.0};
    if (!mirror || !through || weight >= split_above) return result;
    const double sum = mirror_share + through_share;
    if (!(sum > 0.0)) return result;
    const double p = mirror_share / sum;
    if (branch_chance(key) < p) {
        result.mirror_gain = 1.0 / p;
        result.through = false;
    } else {
        result.through_gain = 1.0 / (1.0 - p);
        result.mirror = false;
    }
    return result;
}

/// The gain of a ray of very low weight that survives by chance; 0: it does not.
inline double survive(double weight, std::uint64_t key) {
    if (weight >= roulette_below) return 1.0;
    const double survival = std::max(weight / roulette_below, 0.05);
    return survival_chance(key) < survival ? 1.0 / survival : 0.0;
}

}  // namespace meniscus::lanes
