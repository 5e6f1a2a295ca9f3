#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lanes/program.hpp"
#include "lanes/ray_stack.hpp"

namespace meniscus::lanes {

inline bool share(const Places& a, const Places& b) {
    for (std::size_t w = 0; w < a.size(); ++w) {
        if ((a[w] & b[w]) != 0) return true;
    }
    return false;
}

/// Rays that go to lights, and rays that see: what they need differs. Those that see wait in bins,
/// by what they are in, so that those of one step have more in common: in the open no ray comes
/// near the bubbles in a glass, in the glass none sees them, and only in the open are the floor and
/// the sky met. In which bin a ray waits changes nothing but that.
class Stacks {
public:
    /// Bins for the strongest member and for others that are stronger than all small spheres, if
    /// there are some; for all others; and for the open.
    explicit Stacks(const Program& program) {
        Places members{}, hiding{};
        for (std::size_t rank = 0; rank < program.members.size(); ++rank) {
            const std::uint64_t bit = 1ull << (rank % 64);
            members[rank / 64] |= bit;
            if (program.members[rank].in_group) {
                hiding = {};
            } else if (rank + 1 < program.members.size()) {
                hiding[rank / 64] |= bit;
            } else if (!program.groups.empty()) {
                places_.emplace_back()[rank / 64] = bit;
            }
        }
        if (!program.groups.empty() && hiding != Places{}) places_.push_back(hiding);
        places_.push_back(members);
        bins.resize(places_.size() + 1);
    }

    RayStack shadows;
    std::vector<RayStack> bins;  // the last one: of rays in the open

    /// What the rays in a bin are in, unless they are in what has an earlier one.
    const Places& places(std::size_t bin) const { return places_[bin]; }
    RayStack& in_the_open() { return bins.back(); }
    RayStack& bin_of(const Places& inside) {
        std::size_t i = 0;
        while (i < places_.size() && !share(inside, places_[i])) ++i;
        return bins[i];
    }
    RayStack& fullest() {
        return *std::ranges::max_element(bins, {}, [](const RayStack& bin) { return bin.size(); });
    }

private:
    std::vector<Places> places_;
};

}  // namespace meniscus::lanes
