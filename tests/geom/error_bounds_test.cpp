#include <catch2/catch.hpp>

#include "tests/geom/error_census.hpp"

namespace meniscus::geom {

namespace {

/// c of |error of t| |d.n| <= c u M, as docs/numerics.md states it.
constexpr double bound = 8.0;

void check(Kind kind, int lines) {
    for (const Placement placement : all_placements) {
        const Census found = census(kind, placement, lines, 1);
        INFO(name(kind) << ", " << name(placement) << ", " << found.crossings << " crossings");
        CHECK(found.crossings > found.lines / 4);
        CHECK(found.worst <= bound);
    }
}

}  // namespace

TEST_CASE("crossings obey the law of errors, says quad precision", "[geom]") {
    for (const Kind kind : all_kinds) check(kind, 1000);
}

// 1e5 lines for each kind: some minutes.
TEST_CASE("crossings obey the law of errors on 1e5 lines a shape", "[.][census]") {
    for (const Kind kind : all_kinds) check(kind, 25000);
}

}  // namespace meniscus::geom
