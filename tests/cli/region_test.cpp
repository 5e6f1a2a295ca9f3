#include <catch2/catch.hpp>

#include "cli/exit_code.hpp"
#include "cli/tracer_options.hpp"

using namespace meniscus;
using cli::make_tracer_options;

namespace {

using Edges = std::vector<int>;

/// Of a picture of 8 x 8.
Edges region(const cli::TracerOptions& options) {
    cli::SceneOptions scene;
    scene.width = scene.height = 8;
    const auto r = make_tracer_options(options, scene).region;
    return r ? Edges{r->x0, r->y0, r->x1, r->y1} : Edges{};
}

Edges columns(std::optional<double> start, std::optional<double> end) {
    cli::TracerOptions options;
    options.start_column = start;
    options.end_column = end;
    const auto edges = region(options);
    return edges.empty() ? Edges{} : Edges{edges[0], edges[2]};
}

}  // namespace

// The numbers are those that POV-Ray 3.7 prints for +W8 +H8, made 0-based and half open.
TEST_CASE("columns are those of POV-Ray", "[cli]") {
    CHECK(columns({}, {}) == Edges{});
    CHECK(columns(1, 1) == Edges{0, 8});
    CHECK(columns(0.5, {}) == Edges{4, 8});
    CHECK(columns(2, 1.0) == Edges{1, 8});
    CHECK(columns(0.25, 0.5) == Edges{2, 4});
    CHECK(columns(0.3, {}) == Edges{2, 8});
    CHECK(columns(0.2, {}) == Edges{1, 8});
    CHECK(columns({}, 0.4) == Edges{0, 3});
    CHECK(columns({}, 0.45) == Edges{0, 3});
    CHECK(columns(2, 3) == Edges{1, 3});
    CHECK(columns(0, {}) == Edges{0, 8});
}

TEST_CASE("regions outside the picture or without pixels are refused", "[cli]") {
    CHECK_THROWS_AS(columns({}, 9), cli::UsageError);
    CHECK_THROWS_AS(columns(5, 3), cli::UsageError);
    cli::TracerOptions options;
    options.region = {0, 0, 8, 8};
    CHECK(region(options) == Edges{0, 0, 8, 8});
    options.region = {-1, 0, 8, 8};
    CHECK_THROWS_AS(region(options), cli::UsageError);
    options.region = {3, 3, 3, 8};
    CHECK_THROWS_AS(region(options), cli::UsageError);
}
