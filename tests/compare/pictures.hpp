#pragma once

#include "compare/comparison.hpp"

/// Small pictures to compare.
namespace meniscus::test {

inline image::Image plain(int width, int height, float value) {
    image::Image picture(width, height);
    for (float& v : picture.rgb) v = value;
    return picture;
}

inline compare::Side side(std::string name, image::Image picture) {
    return {.name = std::move(name), .picture = std::move(picture), .facts = {}, .command = {}};
}

/// 8 x 4, grey; "B" is brighter by 0.5 in one pixel's green and darker by 0.02 in another's blue.
inline compare::Comparison two_differences() {
    auto a = plain(8, 4, 0.25f), b = a;
    b.pixel(5, 1)[1] += 0.5f;
    b.pixel(2, 3)[2] -= 0.02f;
    return compare::compare(side("A", a), side("B", b), {});
}

}  // namespace meniscus::test
