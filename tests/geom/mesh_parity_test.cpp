#include "tests/geom/mesh_parity.hpp"

#include <catch2/catch.hpp>

namespace meniscus::geom {

TEST_CASE("a million lines at edges and vertices enter and leave in turn", "[geom]") {
    const Parity parity = mesh_parity(1000000, 3);
    CHECK(parity.crossings > parity.lines);
    CHECK(parity.unbalanced == 0);
    CHECK(parity.out_of_turn == 0);
}

}  // namespace meniscus::geom
