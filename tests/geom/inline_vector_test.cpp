#include "geom/inline_vector.hpp"

#include <catch2/catch.hpp>

namespace meniscus::geom {

TEST_CASE("an inline vector grows, shrinks, copies and moves on either side of its limit",
          "[geom]") {
    for (const int count : {0, 3, 4, 5, 9}) {
        InlineVector<int, 4> a;
        for (int i = 0; i < count; ++i) a.push_back(i);
        const InlineVector<int, 4> copy = a;
        InlineVector<int, 4> moved = std::move(a);
        for (const auto& list : {copy, moved}) {
            REQUIRE(static_cast<int>(list.size()) == count);
            for (int i = 0; i < count; ++i) REQUIRE(list[i] == i);
        }
        if (count > 0) {
            moved.erase(0);
            REQUIRE(static_cast<int>(moved.size()) == count - 1);
            for (int i = 1; i < count; ++i) REQUIRE(moved[i - 1] == i);
        }
        moved.clear();
        moved.push_back(7);
        CHECK(moved.back() == 7);
    }
}

}  // namespace meniscus::geom
