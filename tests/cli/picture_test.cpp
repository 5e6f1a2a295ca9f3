#include <catch2/catch.hpp>

#include "image/save.hpp"
#include "tests/cli/program.hpp"

using namespace meniscus;

namespace {

const std::string small = " -W 16 -H 12 --spp 1 --quiet ";

}  // namespace

TEST_CASE("option -o - writes the same PNG to standard output", "[cli]") {
    const Program program;
    program.run("render ball.scene" + small);
    const auto result = program.run("render ball.scene -o -" + small);
    CHECK(result.exit_code == 0);
    CHECK(result.out == program.read("ball.png"));
}

TEST_CASE("a scene called - is read from standard input", "[cli]") {
    const Program program;
    const auto result = program.run("render - -o a.png" + small + "<ball.scene");
    CHECK(result.exit_code == 0);
    program.run("render ball.scene" + small);
    CHECK(image::load(program.path("a.png")).rgb == image::load(program.path("ball.png")).rgb);
}

TEST_CASE("EXR holds what PNG rounds", "[cli]") {
    const Program program;
    program.run("render ball.scene -o a.exr" + small);
    program.run("render ball.scene -o a.png --bits 16" + small);
    const auto exr = image::load(program.path("a.exr"));
    const auto png = image::load(program.path("a.png"));
    CHECK(exr.pixel(0, 0)[1] == 0.5f);
    for (std::size_t i = 0; i < exr.rgb.size(); ++i)
        CHECK_THAT(png.rgb[i], Catch::WithinAbs(std::min(exr.rgb[i], 1.0f), 2e-5));
}

TEST_CASE("option --layers adds the layers that it names, and no other", "[cli]") {
    const Program program;
    const auto names = [&](const std::string& list) {
        CHECK(program.run("render ball.scene -o a.exr --layers " + list + small).exit_code == 0);
        std::vector<std::string> result;
        for (const auto& layer : image::load(program.path("a.exr")).layers)
            result.push_back(layer.name);
        return result;
    };
    using Names = std::vector<std::string>;
    CHECK(names("depth") == Names{"depth.Z"});
    CHECK(names("object,N") == Names{"N.X", "N.Y", "N.Z", "object.ID"});
    CHECK(names("depth,all").size() == names("N,Variance,depth,medium,object,samples").size());
    const auto refused = program.run("render ball.scene -o a.exr --layers depth,odd" + small);
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Catch::Contains("'odd'") && Catch::Contains("N, Variance, depth"));
}

TEST_CASE("option --depth 16 is --bits 16 where no tree has a depth", "[cli]") {
    const Program program;
    program.run("render ball.scene -o a.png --depth 16" + small);
    program.run("render ball.scene -o b.png --bits 16" + small);
    program.run("render ball.scene -o c.png --depth 16 --tree full" + small);
    CHECK(program.read("a.png") == program.read("b.png"));
    CHECK(program.read("a.png").at(24) == 16);
    CHECK(program.read("c.png").at(24) == 8);
}

TEST_CASE("two runs give equal bytes, for any number of threads", "[cli]") {
    const Program program;
    for (const std::string sampling : {"--spp 1", "--spp 4", "--grid 2", "--aa 0.05"}) {
        const auto options = "render ball.scene --quiet -W 48 -H 36 " + sampling;
        CAPTURE(sampling);
        CHECK(program.run(options + " -o a.exr").exit_code == 0);
        program.run(options + " -o b.exr --threads 1");
        CHECK(program.read("a.exr") == program.read("b.exr"));
    }
}

TEST_CASE("a region is that part of the whole picture", "[cli]") {
    const Program program;
    program.run("render ball.scene -o all.exr" + small);
    program.run("render ball.scene -o part.exr --region 4 3 12 8" + small);
    program.run("render ball.scene -o part.png --region 4 3 12 8" + small);
    program.run("render ball.scene -o pov.exr +SC5 +SR4 +EC12 +ER8" + small);
    const auto all = image::load(program.path("all.exr"));
    const auto part = image::load(program.path("part.exr"));
    const auto png = image::load(program.path("part.png"));
    REQUIRE(part.width == 8);
    REQUIRE(part.height == 5);
    CHECK(part.full_width == 16);
    CHECK(image::load(program.path("pov.exr")).rgb == part.rgb);
    CHECK(png.width == 16);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 16; ++x) {
            const bool inside = x >= 4 && x < 12 && y >= 3 && y < 8;
            if (inside) CHECK(part.pixel(x - 4, y - 3)[2] == all.pixel(x, y)[2]);
            if (!inside) CHECK(png.pixel(x, y)[2] == 0.0f);
        }
}

TEST_CASE("POV-Ray's spellings make the same picture", "[cli]") {
    const Program program;
    program.run("render ball.scene -o a.png" + small);
    const auto result = program.run("+Iball.scene +Ob.png +W16 +H12 -A -D --quiet");
    CHECK(result.exit_code == 0);
    CHECK(program.read("a.png") == program.read("b.png"));
}

TEST_CASE("the picture says how it was made", "[cli]") {
    const Program program;
    for (const std::string name : {"a.png", "a.exr"}) {
        program.run("render ball.scene -o " + name + small);
        const auto bytes = program.read(name);
        for (const std::string text : {"Meniscus", "ball.scene", "--grid 1", "whitted"})
            CHECK_THAT(bytes, Catch::Contains(text));
    }
}
