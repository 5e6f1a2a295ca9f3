// Compares random scenes with the oracle, seed after seed: oracle_soak FIRST LAST. Prints each seed
// that has a leak, a median difference above 1e-9 or a pixel that is off by more than 1e-3 without
// a reason, and the sums so far every 20 scenes.

#include <fmt/format.h>

#include <cstdlib>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"

using namespace meniscus;

namespace {

struct Sum {
    std::size_t scenes = 0, pixels = 0, off = 0, unexplained = 0, medians = 0;
    std::uint64_t leaks = 0;

    bool is_sound() const { return unexplained == 0 && medians == 0 && leaks == 0; }
    void add(const oracle::Difference& difference) {
        ++scenes;
        pixels += difference.pixels;
        off += difference.off;
        unexplained += difference.unexplained;
        medians += difference.median >= 1e-9;
        leaks += difference.leaks;
    }
    void print(std::uint64_t first, std::uint64_t last) const {
        fmt::print(
            "seeds {} to {}: {} scenes, {} pixels: {} off by 1e-6, {} by 1e-3 without a reason; {} "
            "medians above 1e-9; {} leaks\n",
            first, last, scenes, pixels, off, unexplained, medians, leaks);
        std::fflush(stdout);
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "usage: oracle_soak FIRST LAST\n");
        return 2;
    }
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
    const std::uint64_t last = std::strtoull(argv[2], nullptr, 10);
    Sum sum;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        const auto options = oracle::every_kind(seed);
        oracle::Picture picture;
        picture.limits.contact = oracle::contact_of(options);
        const auto difference =
            oracle::compare_closely(oracle::random_scene(seed, options), picture);
        sum.add(difference);
        Sum one;
        one.add(difference);
        if (!one.is_sound()) fmt::print("seed {}: {}\n", seed, difference.text());
        if (sum.scenes % 20 == 0) sum.print(first, seed);
    }
    sum.print(first, last);
    return sum.is_sound() ? 0 : 4;
}
