#include "geom/polygon.hpp"

#include <catch2/catch.hpp>

namespace meniscus::geom {

namespace {

bool covers(const Polygon& polygon, double x, double y) {
    Crossings hits;
    polygon.hits({{x, y, -5.0}, {0.0, 0.0, 1.0}}, hits);
    return !hits.empty();
}

}  // namespace

TEST_CASE("a second loop is a hole in a polygon", "[geom]") {
    const Polygon frame({{0, 0, 0},
                         {3, 0, 0},
                         {3, 3, 0},
                         {0, 3, 0},
                         {0, 0, 0},
                         {1, 1, 0},
                         {2, 1, 0},
                         {2, 2, 0},
                         {1, 2, 0},
                         {1, 1, 0}});
    CHECK(covers(frame, 0.5, 1.5));
    CHECK_FALSE(covers(frame, 1.5, 1.5));
    CHECK(covers(frame, 2.5, 0.5));
    CHECK_FALSE(covers(frame, 3.5, 0.5));
}

TEST_CASE("of two polygons that share a side every line meets just one", "[geom]") {
    const Polygon left({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    const Polygon right({{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}});
    CHECK(covers(left, 1.0, 0.5) != covers(right, 1.0, 0.5));
}

TEST_CASE("a polygon that is none says why", "[geom]") {
    CHECK_THROWS_WITH(Polygon({{0, 0, 0}, {1, 0, 0}}), Catch::Contains("three points"));
    CHECK_THROWS_WITH(Polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), Catch::Contains("one line"));
    CHECK_THROWS_WITH(Polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}),
                      Catch::Contains("one plane"));
}

}  // namespace meniscus::geom
