#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "image/save.hpp"
#include "tests/cli/program.hpp"
#include "tests/compare/pictures.hpp"

using namespace meniscus;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

void save(const Program& program, const std::string& name, const image::Image& picture,
          int bits = 8) {
    image::SaveOptions options;
    options.format = *image::format_of(name);
    options.png.bits = bits;
    image::save(picture, program.path(name), options, {});
}

}  // namespace

TEST_CASE("compare tells how far two pictures are apart", "[compare]") {
    const Program program;
    save(program, "a.exr", test::plain(4, 2, 0.5f));
    auto other = test::plain(4, 2, 0.5f);
    other.pixel(3, 1)[0] = 0.75f;
    save(program, "b.exr", other);
    const auto text = program.run("compare a.exr b.exr");
    CHECK(text.exit_code == 0);
    CHECK_THAT(text.out, Contains("(3, 1) 0.25"));
    const auto json = Json::parse(program.run("compare a.exr b.exr --json -").out);
    const auto& all = json.at("comparisons").at(0).at("all");
    CHECK(all.at("rmse").get<double>() == Approx(0.25 / std::sqrt(24.0)));
    CHECK(all.at("off") == 1);
}

TEST_CASE("above the tolerance the exit code is 4", "[compare]") {
    const Program program;
    save(program, "a.exr", test::plain(2, 2, 0.5f));
    save(program, "b.exr", test::plain(2, 2, 0.51f));
    CHECK(program.run("compare a.exr b.exr --tolerance 0.011").exit_code == 0);
    CHECK(program.run("compare a.exr b.exr --tolerance 0.009").exit_code == 4);
    CHECK_THAT(program.run("compare a.exr b.exr --tolerance 0.009").out, Contains("above"));
}

TEST_CASE("PNG of 8 and 16 bits and EXR compare in linear light", "[compare]") {
    const Program program;
    const auto picture = test::plain(3, 3, 0.2f);
    save(program, "a.exr", picture);
    save(program, "b8.png", picture);
    save(program, "b16.png", picture, 16);
    // 0.2 is 0.48453 in sRGB: 123.555 of 255 becomes 124, 31753.7 of 65535 becomes 31754.
    const auto error = [&](const std::string& inputs) {
        const auto json = Json::parse(program.run("compare " + inputs + " --json -").out);
        return json.at("comparisons").at(0).at("all").at("largest").get<double>();
    };
    CHECK(error("a.exr b8.png") == Approx(image::srgb_decode(124 / 255.0) - 0.2).margin(1e-7));
    CHECK(error("a.exr b16.png") < 1e-5);
    CHECK(error("b8.png b16.png") == Approx(error("a.exr b8.png")).margin(1e-5));
}

TEST_CASE("beside a PNG values are clipped, between EXRs on demand", "[compare]") {
    const Program program;
    save(program, "bright.exr", test::plain(2, 2, 4.0f));
    save(program, "white.png", test::plain(2, 2, 1.0f));
    save(program, "white.exr", test::plain(2, 2, 1.0f));
    CHECK(program.run("compare bright.exr white.png --tolerance 0").exit_code == 0);
    CHECK(program.run("compare bright.exr white.exr --tolerance 0").exit_code == 4);
    CHECK(program.run("compare bright.exr white.exr --clip --tolerance 0").exit_code == 0);
}

TEST_CASE("the layers that render adds tell the inside of glass", "[compare]") {
    const Program program;
    REQUIRE(program.run("render ball.scene -W 32 -H 24 --spp 1 --layers all -o a.exr --quiet")
                .exit_code == 0);
    const auto json = Json::parse(program.run("compare a.exr a.exr --json -").out);
    const auto& regions = json.at("comparisons").at(0).at("regions");
    // A ball of radius 1, 4 away: its disc has a radius of 24 * tan(asin(1/4)) = 6.2 pixels, 120 of
    // area, of which a rim of one pixel is an edge.
    CHECK(regions.at("inside glass").at("pixels") > 60);
    CHECK(regions.at("inside glass").at("pixels") < 120);
    CHECK(regions.at("outside").at("pixels") > 400);
    CHECK(regions.at("edges").at("pixels") > 30);
}

TEST_CASE("the difference is saved in colours or as it is", "[compare]") {
    const Program program;
    save(program, "a.exr", test::plain(2, 2, 0.5f));
    auto other = test::plain(2, 2, 0.5f);
    other.pixel(1, 0)[0] = 0.25f;
    save(program, "b.exr", other);
    REQUIRE(program.run("compare a.exr b.exr -o d.exr").exit_code == 0);
    CHECK(image::load(program.path("d.exr")).pixel(1, 0)[0] == -0.25f);
    REQUIRE(program.run("compare a.exr b.exr -o d.png").exit_code == 0);
    const auto map = image::load(program.path("d.png"));
    CHECK(map.pixel(0, 0)[0] == 1.0f);
    CHECK(map.pixel(1, 0)[2] > map.pixel(1, 0)[0]);
}

TEST_CASE("what cannot be compared gets one clear error", "[compare]") {
    const Program program;
    save(program, "a.png", test::plain(4, 2, 0.5f));
    save(program, "b.png", test::plain(2, 4, 0.5f));
    const auto [arguments, code, words] = GENERATE(table<std::string, int, std::string>({
        {"a.png b.png", 2, "a.png is 4 x 2 pixels and b.png is 2 x 4"},
        {"a.png", 2, "two pictures"},
        {"a.png ball.scene", 2, "two pictures"},
        {"a.png a.png b.png", 2, "two pictures"},
        {"a.png missing.png", 3, "missing.png"},
        {"a.png a.png -o out.jpg", 2, "must end in .png or .exr"},
        {"a.png a.png --povray x.pov", 2, "--povray"},
        {"ball.scene wrong.scene --report r.html", 2, "one scene at a time"},
        {"missing.scene", 3, "missing.scene"},
        {"ball.scene --model gap", 2, "--gap G go together"},
        {"ball.scene --model contact --povray ball.scene", 2, "exclude each other"},
        {"ball.scene --povray ball.scene --sweep-gap 1:x", 2, "1e-1:1e-9"},
        {"ball.scene --povray ball.scene --sweep-gap 1:0", 2, "1e-1:1e-9"},
        {"ball.scene --povray ball.scene --csv gap.csv", 2, "--sweep-gap"},
        {"ball.scene --sweep-gap 1e-1:1e-2 --model gap --gap 0.1", 2, "--sweep-gap"},
    }));
    CAPTURE(arguments);
    const auto result = program.run("compare " + arguments);
    CHECK(result.exit_code == code);
    CHECK_THAT(result.err, Contains(words));
}

TEST_CASE("without POV-Ray compare says how to get it", "[compare]") {
    const Program program;
    const auto result =
        program.shell("PATH=/nowhere " MENISCUS_BINARY " compare ball.scene -W 8 -H 6");
    CHECK(result.exit_code == 3);
    CHECK_THAT(result.err, Contains("POV-Ray is not installed") && Contains("apt-get install"));
}
