#include "tracer/sampler.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace meniscus;

TEST_CASE("the first 2^m points put one into every elementary interval", "[tracer]") {
    for (const std::uint64_t seed : {1ull, 77ull, 123456789ull}) {
        for (int m = 0; m <= 6; ++m) {
            const int count = 1 << m;
            for (int a = 0; a <= m; ++a) {
                std::set<int> cells;
                for (int i = 0; i < count; ++i) {
                    const geom::Vec2 p = tracer::SobolSet(seed).point(std::uint32_t(i));
                    cells.insert((int(p.x * (1 << a)) << 8) + int(p.y * (1 << (m - a))));
                }
                CHECK(cells.size() == std::size_t(count));
            }
        }
    }
}

TEST_CASE("points depend on the seed and lie in the unit square", "[tracer]") {
    CHECK(tracer::SobolSet(1).point(0) != tracer::SobolSet(2).point(0));
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const geom::Vec2 p = tracer::SobolSet(5).point(i);
        CHECK((p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0));
    }
}

TEST_CASE("what chance decides is uniform over keys, within what 100000 of them can tell",
          "[tracer]") {
    const int n = 100000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < n; ++i) {
        const double x = lanes::branch_chance(std::uint64_t(i));
        sum += x;
        squares += x * x;
    }
    // Standard errors: sqrt(1/12/n) = 9.1e-4 and sqrt(4/45/n) = 9.4e-4, five of each.
    CHECK_THAT(sum / n, Catch::WithinAbs(0.5, 4.6e-3));
    CHECK_THAT(squares / n, Catch::WithinAbs(1.0 / 3.0, 4.7e-3));
}
