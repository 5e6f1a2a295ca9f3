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
/// by the strongest solid that they are in, so that those of one step have more in common: they are
/// asked only about what they may come to before they leave it. In which bin a ray waits changes
/// nothing but that.
class Stacks {
public:
    explicit Stacks(const Program& program) : bins(program.bins.size()) {
        for (const Surroundings& bin : program.bins) places_.push_back(bin.places);
    }

    RayStack shadows;
    std::vector<RayStack> bins;  // as the program's

    const Places& places(std::size_t bin) const { return places_[bin]; }
    RayStack& in_the_open() { return bins.back(); }
    RayStack& bin_of(const Places& inside) {
        std::size_t i = 0;
        while (i + 1 < places_.size() && !share(inside, places_[i])) ++i;
        return bins[i];
    }
    std::size_t fullest() const {
        const auto most = std::ranges::max_element(bins, {}, &RayStack::size);
        return std::size_t(most - bins.begin());
    }

private:
    std::vector<Places> places_;
};

}  // namespace meniscus::lanes
