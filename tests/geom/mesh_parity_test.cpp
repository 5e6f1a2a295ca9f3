#include "tests/geom/mesh_parity.hpp"

#include <hwy/targets.h>

#include <catch2/catch.hpp>

namespace meniscus::geom {

namespace {

void check(const Parity& parity) {
    CHECK(parity.alone.crossings > parity.alone.lines);
    CHECK(parity.alone.unbalanced == 0);
    CHECK(parity.alone.out_of_turn == 0);
    CHECK(parity.in_turns.lines == parity.alone.lines);
    CHECK(parity.in_turns.crossings == parity.alone.crossings);
    CHECK(parity.in_turns.unbalanced == 0);
    CHECK(parity.ahead.lines > parity.asked / 2);
    CHECK(parity.ahead.unbalanced == 0);
    CHECK(parity.ahead.out_of_turn == 0);
    CHECK(parity.differing == 0);
    CHECK(parity.astray == 0);
}

}  // namespace

TEST_CASE("a million lines at edges and vertices enter and leave in turn", "[geom]") {
    const Parity parity = mesh_parity(1000000, 3);
    CHECK(parity.alone.lines == 1000000);
    check(parity);
}

TEST_CASE("lines at edges and vertices enter and leave in turn on every kind of processor",
          "[geom]") {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        INFO(hwy::TargetName(target));
        check(mesh_parity(20000, 4));
    }
    hwy::SetSupportedTargetsForTest(0);
}

}  // namespace meniscus::geom
