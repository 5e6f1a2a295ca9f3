#include "geom/polynomial.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/geom/lines.hpp"

namespace meniscus::geom {

TEST_CASE("a polynomial made from its roots gives them back", "[geom]") {
    Dice dice(4);
    for (int i = 0; i < 2000; ++i) {
        std::vector<double> roots, c{dice.between(0.5, 2.0)};
        const int degree = 1 + dice.below(6);
        for (int k = 0; k < degree; ++k) {
            const double root = 0.1 * k + dice.between(0.0, 0.05);
            roots.push_back(root);
            c.push_back(0.0);
            for (std::size_t j = c.size() - 1; j > 0; --j) c[j] = c[j - 1] - root * c[j];
            c[0] *= -root;
        }
        const Roots found = roots_between(c, -1.0, 2.0);
        REQUIRE(found.size() == roots.size());
        for (int k = 0; k < degree; ++k) REQUIRE(found[k] == Approx(roots[k]).margin(1e-9));
    }
}

TEST_CASE("roots outside the range are not asked for", "[geom]") {
    const double cubic[] = {0.0, -1.0, 0.0, 1.0};  // -1, 0, 1
    CHECK(roots_between(cubic, -0.5, 2.0).size() == 2);
    CHECK(roots_between(cubic, 2.0, 3.0).empty());
}

}  // namespace meniscus::geom
