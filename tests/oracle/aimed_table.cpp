// Prints how many rays that were aimed at something, or beside it, leak or differ from the
// oracle's: aimed_table RAYS SEED, with RAYS of each kind at each distance.

#include <fmt/format.h>

#include <cstdlib>

#include "tests/oracle/aimed_rays.hpp"
#include "tests/random/random.hpp"

using namespace meniscus;

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "usage: aimed_table RAYS SEED\n");
        return 2;
    }
    const int rays = std::atoi(argv[1]);
    const std::uint64_t first = std::strtoull(argv[2], nullptr, 10);
    const double distances[] = {0.0,   1e-15, 1e-14, 1e-13, 1e-12, 1e-11,
                                1e-10, 1e-9,  1e-8,  1e-7,  1e-6,  1e-5};

    fmt::print("| aimed at |");
    for (const double beside : distances) fmt::print(" {:.0e} |", beside);
    fmt::print("\n");
    std::uint64_t segments = 0, leaks = 0, unexplained = 0;
    Random random(first);
    oracle::AimedScene straight(geom::Vec3{0.0}), turned(random.point(-180.0, 180.0));
    for (int kind = 0; kind < oracle::aims; ++kind) {
        const auto aim = oracle::Aim(kind);
        fmt::print("| {} |", name(aim));
        for (const double beside : distances) {
            int off = 0;
            for (int i = 0; i < rays; ++i) {
                auto& scene = i % 2 == 0 ? straight : turned;
                const std::uint64_t seed = first + std::uint64_t(kind * rays + i);
                const auto ray = oracle::compared(scene.aimed(aim, beside, seed));
                segments += ray.segments;
                leaks += ray.leaks;
                off += ray.difference > 1e-6 && !ray.is_one_of_two;
                unexplained += !ray.is_explained;
                if (ray.leaks > 0 || !ray.is_explained)
                    fmt::print(stderr, "{} leaks, {} off of a ray at {:.0e} from {}, seed {}, {}\n",
                               ray.leaks, ray.difference, beside, name(aim), seed,
                               i % 2 == 0 ? "straight" : "turned");
            }
            fmt::print(" {} |", off);
            std::fflush(stdout);
        }
        fmt::print("\n");
    }
    fmt::print(
        "{} rays of each kind at each distance, {} segments, {} leaks, {} off without a reason\n",
        rays, segments, leaks, unexplained);
    return leaks == 0 && unexplained == 0 ? 0 : 4;
}
