#include "image/exr.hpp"

#include <catch2/catch.hpp>

using namespace meniscus::image;

namespace {

/// Values that need all 32 bits, beyond 1 and below 0.
Image hard_values() {
    Image image(4, 3);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = float(i) * 1.2345678f - 3.0f;
    return image;
}

}  // namespace

TEST_CASE("EXR keeps every bit of 32-bit floats", "[image]") {
    const auto image = hard_values();
    const auto back = decode_exr(encode_exr(image, {}, {}));
    CHECK(back.width == 4);
    CHECK(back.height == 3);
    CHECK(back.rgb == image.rgb);
}

TEST_CASE("half floats keep eleven bits", "[image]") {
    const auto image = hard_values();
    const auto back = decode_exr(encode_exr(image, {.half = true}, {}));
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        CHECK_THAT(back.rgb[i], Catch::WithinRel(image.rgb[i], 1.0f / 2048));
}

TEST_CASE("layers are channels of their own", "[image]") {
    auto image = hard_values();
    image.layers.push_back({"Variance.R", std::vector<float>(12, 0.25f)});
    image.layers.push_back({"depth.Z", std::vector<float>(12, 1e20f)});
    const auto back = decode_exr(encode_exr(image, {.half = true}, {}));
    REQUIRE(back.layers.size() == 2);
    CHECK(back.layers[0].name == "Variance.R");
    CHECK(back.layers[0].values == image.layers[0].values);
    CHECK(back.layers[1].name == "depth.Z");
    CHECK(back.layers[1].values == image.layers[1].values);
}

TEST_CASE("a region is the data window", "[image]") {
    auto part = hard_values();
    part.x0 = 5;
    part.y0 = 6;
    part.full_width = 20;
    part.full_height = 10;
    part.layers.push_back({"depth.Z", std::vector<float>(12, 2.0f)});
    for (const bool half : {false, true}) {
        const auto back = decode_exr(encode_exr(part, {half}, {}));
        CHECK(back.x0 == 5);
        CHECK(back.y0 == 6);
        CHECK(back.width == 4);
        CHECK(back.height == 3);
        CHECK(back.full_width == 20);
        CHECK(back.full_height == 10);
        CHECK_THAT(back.rgb[35], Catch::WithinRel(part.rgb[35], 1.0f / 2048));
        CHECK(back.layers.at(0).values == part.layers[0].values);
    }
}

TEST_CASE("EXR carries its metadata, and equal pictures give equal bytes", "[image]") {
    const Metadata metadata{{"Scene", "glass"}, {"Samples", "16"}};
    const auto bytes = encode_exr(hard_values(), {}, metadata);
    CHECK_THAT(bytes, Catch::Contains("Scene") && Catch::Contains("glass"));
    CHECK(encode_exr(hard_values(), {}, metadata) == bytes);
}

TEST_CASE("an EXR's header tells its floats and its metadata", "[image]") {
    for (const bool half : {false, true}) {
        const auto header = decode_exr_header(
            encode_exr(hard_values(), {.half = half}, {{"Scene", "glass.scene"}}));
        CHECK(header.half == half);
        CHECK(header.metadata.at("Scene") == "glass.scene");
    }
}
