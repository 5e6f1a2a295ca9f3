#include "image/png.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace meniscus::image;

namespace {

Image gray_ramp(int count) {
    Image image(count, 1);
    for (int x = 0; x < count; ++x)
        for (int c = 0; c < 3; ++c) image.pixel(x, 0)[c] = float(x) / float(count - 1);
    return image;
}

}  // namespace

TEST_CASE("PNG values survive a round trip to half a step", "[image]") {
    const auto image = gray_ramp(500);
    for (const int bits : {8, 16})
        for (const auto encoding : {Encoding::srgb, Encoding::linear}) {
            const auto back = decode_png(encode_png(image, {bits, encoding}, {}));
            REQUIRE(back.rgb.size() == image.rgb.size());
            // The sRGB curve is at most 2.3 times steeper in light than in code, at white.
            const double step = 2.3 * 0.5 / (bits == 16 ? 65535 : 255) + 1e-7;
            for (std::size_t i = 0; i < image.rgb.size(); ++i)
                CHECK_THAT(back.rgb[i], Catch::WithinAbs(image.rgb[i], step));
        }
}

TEST_CASE("a second round trip changes nothing", "[image]") {
    for (const int bits : {8, 16}) {
        const auto once = encode_png(gray_ramp(300), {.bits = bits}, {});
        CHECK(encode_png(decode_png(once), {.bits = bits}, {}) == once);
    }
}

TEST_CASE("rows and channels keep their places", "[image]") {
    Image image(2, 2);
    image.pixel(1, 0)[0] = 1.0f;
    image.pixel(0, 1)[1] = 1.0f;
    image.pixel(1, 1)[2] = 1.0f;
    for (const int bits : {8, 16})
        CHECK(decode_png(encode_png(image, {.bits = bits}, {})).rgb == image.rgb);
}

TEST_CASE("a region is a full-size PNG, black outside", "[image]") {
    Image part(2, 1);
    part.x0 = 1;
    part.y0 = 2;
    part.full_width = 4;
    part.full_height = 5;
    part.rgb.assign(6, 1.0f);
    const auto image = decode_png(encode_png(part, {}, {}));
    REQUIRE(image.width == 4);
    REQUIRE(image.height == 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 4; ++x)
            CHECK(image.pixel(x, y)[0] == (y == 2 && (x == 1 || x == 2) ? 1.0f : 0.0f));
}

TEST_CASE("PNG carries its metadata and no time", "[image]") {
    const auto bytes = encode_png(Image(1, 1), {}, {{"Scene", "glass"}, {"Author", "Zo\xc3\xab"}});
    CHECK_THAT(bytes, Catch::Contains(std::string("Scene\0glass", 11)));
    CHECK_THAT(bytes, Catch::Contains("Zo\xc3\xab"));
    CHECK_THAT(bytes, Catch::Contains("sRGB"));
    CHECK_THAT(bytes, !Catch::Contains("tIME"));
}

TEST_CASE("equal pictures give equal bytes", "[image]") {
    const Metadata metadata{{"Scene", "glass"}};
    CHECK(encode_png(gray_ramp(99), {}, metadata) == encode_png(gray_ramp(99), {}, metadata));
}

TEST_CASE("a picture too large for PNG is refused", "[image]") {
    Image part(1, 1);
    part.full_width = (1 << 16) + 1;
    part.full_height = 1;
    CHECK_THROWS_WITH(encode_png(part, {}, {}), Catch::Contains("PNG"));
}

TEST_CASE("a PNG's header tells its bits and its metadata", "[image]") {
    const auto header =
        decode_png_header(encode_png(Image(2, 2), {.bits = 16}, {{"Scene", "glass.scene"}}));
    CHECK(header.bits == 16);
    CHECK(header.metadata == Metadata{{"Scene", "glass.scene"}});
}
