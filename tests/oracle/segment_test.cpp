// Not looking is no way to no leaks: what the tracer's lists say is asked of the exact scene.

#include <catch2/catch.hpp>

#include "tests/oracle/random_scene.hpp"
#include "tests/oracle/segment_check.hpp"

using namespace meniscus::oracle;

TEST_CASE("every segment runs in the medium that its list says", "[oracle][segment]") {
    SegmentCheck sum;
    for (std::uint64_t seed = 4000; seed < 4100; ++seed) {
        const auto scene = random_scene(seed, {.fewest_solids = 2,
                                               .most_solids = 12,
                                               .rotated = seed % 2 == 1,
                                               .stretched = seed % 3 == 1,
                                               .sheared = seed % 5 == 1,
                                               .cones = true,
                                               .tori = true,
                                               .lathes = seed % 4 == 0,
                                               .meshes = true,
                                               .unions = seed % 3 == 2,
                                               .complements = seed % 7 == 1});
        const auto check = check_segments(scene, seed, 1000);
        INFO("seed " << seed);
        CHECK(check.wrong == 0);
        CHECK(check.leaks == 0);
        sum.segments += check.segments;
    }
    CHECK(sum.segments == 100'000);
}
