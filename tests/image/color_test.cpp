#include "image/color.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace meniscus::image;

TEST_CASE("sRGB values are those of the standard's formula", "[image]") {
    CHECK(srgb_encode(0.0) == 0.0);
    CHECK_THAT(srgb_encode(0.001), Catch::WithinULP(0.01292, 1));
    CHECK_THAT(srgb_encode(0.0031308), Catch::WithinAbs(0.04045, 1e-6));
    CHECK_THAT(srgb_encode(0.2), Catch::WithinAbs(0.484529, 1e-6));
    CHECK_THAT(srgb_encode(0.5), Catch::WithinAbs(0.735357, 1e-6));
    CHECK_THAT(srgb_encode(1.0), Catch::WithinAbs(1.0, 1e-15));
}

TEST_CASE("decoding undoes encoding", "[image]") {
    for (int i = 0; i <= 1000; ++i) {
        const double v = i / 1000.0;
        CHECK_THAT(srgb_decode(srgb_encode(v)), Catch::WithinAbs(v, 1e-7));
    }
}

TEST_CASE("values are rounded as POV-Ray rounds them", "[image]") {
    CHECK(quantize(0.2, Encoding::srgb, 255) == 124);
    CHECK(quantize(0.5, Encoding::srgb, 255) == 188);
    CHECK(quantize(0.2, Encoding::srgb, 65535) == 31754);
    CHECK(quantize(0.5, Encoding::srgb, 65535) == 48192);
    CHECK(quantize(0.2, Encoding::linear, 65535) == 13107);
    CHECK(quantize(0.2, Encoding::raw, 255) == 51);
}

TEST_CASE("what lies outside 0 to 1 is clipped", "[image]") {
    for (const auto encoding : {Encoding::srgb, Encoding::linear, Encoding::raw}) {
        CHECK(quantize(-0.5, encoding, 255) == 0);
        CHECK(quantize(7.0, encoding, 255) == 255);
        CHECK(quantize(std::numeric_limits<double>::infinity(), encoding, 255) == 255);
        CHECK(quantize(std::numeric_limits<double>::quiet_NaN(), encoding, 255) == 0);
    }
}
