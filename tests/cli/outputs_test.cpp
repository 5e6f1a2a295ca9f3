#include <catch2/catch.hpp>

#include "tests/cli/program.hpp"

using Catch::Contains;

namespace {

constexpr auto scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#include "color.png"
camera { location <0, 0, -4> look_at 0 }
sphere { <0, 0, 0>, 1 pigment { Color } }
)";
constexpr auto included = "#declare Color = rgb <1, 0, 0>;\n";
constexpr auto small = " -W 4 -H 3";

}  // namespace

TEST_CASE("no command writes over what it reads", "[cli]") {
    const Program program;
    program.write("w.scene", scene);
    program.write("w.png", scene);
    program.write("color.png", included);
    const std::string arguments =
        GENERATE("render w.scene -o w.scene --format png",
                 "render w.scene -o ./w.scene --format exr", "render w.scene --json w.scene",
                 "render w.png", "render w.scene -o color.png", "check w.scene --json w.scene",
                 "check w.scene --json color.png", "inspect w.scene 1 1 --svg w.scene",
                 "export w.scene -o w.scene", "export w.scene -o color.png",
                 "compare w.scene --json w.scene", "compare w.scene --report color.png",
                 "compare w.scene --sweep-gap 1e-2:1e-2:1 --csv w.scene",
                 "bench w.scene --quick --csv w.scene",
                 "bench w.scene --quick --no-povray --json color.png");
    CAPTURE(arguments);
    const auto result = program.run(arguments + small);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("is read here"));
    CHECK(program.read("w.scene") == scene);
    CHECK(program.read("w.png") == scene);
    CHECK(program.read("color.png") == included);
}

TEST_CASE("two outputs in one file are refused before anything is done", "[cli]") {
    const Program program;
    const auto result =
        program.run(std::string("render ball.scene -o a.png --json ./a.png") + small);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("written twice"));
    CHECK_FALSE(program.exists("a.png"));
}

TEST_CASE("what two options want on standard output is refused", "[cli]") {
    const Program program;
    const auto result = program.run(std::string("inspect ball.scene 1 1 --svg - --json") + small);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
}
