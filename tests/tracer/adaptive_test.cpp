#include "tracer/adaptive.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace meniscus::tracer;

TEST_CASE("pixels get samples where an error falls most for its cost", "[tracer]") {
    const std::vector<PixelNeed> pixels = {{4.0, 1.0}, {5.0, 10.0}, {3.0, 1.0}, {0.0, 1.0}};
    CHECK(choose_pixels(pixels, 11.0) == std::vector<bool>{true, false, false, false});
    CHECK(choose_pixels(pixels, 9.0) == std::vector<bool>{true, false, true, false});
    CHECK(choose_pixels(pixels, 0.0) == std::vector<bool>{true, true, true, false});
    CHECK(choose_pixels(pixels, 12.0) == std::vector<bool>(4, false));
}

TEST_CASE("a pixel that may not grow does not", "[tracer]") {
    const std::vector<PixelNeed> pixels = {{4.0, 1.0, false}, {3.0, 1.0}};
    CHECK(choose_pixels(pixels, 0.0) == std::vector<bool>{false, true});
}

TEST_CASE("samples come to stand as the cheapest way to an error has them", "[tracer]") {
    // Squared errors v / n^1.4 and costs c n: a multiplier shows that (v / c)^(1 / 2.4) is best.
    const std::vector<std::pair<double, double>> known = {{1.0, 1.0}, {100.0, 1.0}, {1.0, 30.0}};
    std::vector<double> counts(known.size(), 8.0);
    const auto needs = [&] {
        std::vector<PixelNeed> needs;
        for (std::size_t i = 0; i < known.size(); ++i)
            needs.push_back(
                {known[i].first * std::pow(counts[i], -1.4), known[i].second * counts[i]});
        return needs;
    };
    for (double allowed = 1.0; allowed > 1e-6; allowed *= 0.7) {
        const auto chosen = choose_pixels(needs(), allowed);
        for (std::size_t i = 0; i < known.size(); ++i)
            if (chosen[i]) counts[i] *= 2.0;
    }
    // Counts are powers of two: within a factor of two of it.
    for (std::size_t i = 1; i < known.size(); ++i) {
        const double best = std::pow(known[i].first / known[i].second, 1.0 / 2.4);
        CHECK(counts[i] / counts[0] > 0.49 * best);
        CHECK(counts[i] / counts[0] < 2.1 * best);
    }
}
