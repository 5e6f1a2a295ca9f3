#include "povray/run.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "image/file.hpp"
#include "povray/console.hpp"
#include "povray/scratch.hpp"

using namespace meniscus;
using Catch::Matchers::Contains;

namespace {

constexpr auto gray_scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#ifndef (Level) #declare Level = 0.25; #end
background { rgb <Level, 0.5, 1> }
sphere { -9*z, 1 }
)";

}  // namespace

TEST_CASE("POV-Ray's pictures are linear and of the size asked for", "[povray]") {
    const auto run = povray::run_text(gray_scene, {.width = 9, .height = 5});
    REQUIRE(run.picture.width == 9);
    REQUIRE(run.picture.height == 5);
    CHECK(run.warnings.empty());
    // 16 bits: within half a step of 1/65535
    CHECK(run.picture.pixel(8, 4)[0] == Approx(0.25).margin(8e-6));
    CHECK(run.picture.pixel(8, 4)[1] == Approx(0.5).margin(8e-6));
    CHECK(run.picture.pixel(8, 4)[2] == 1.0f);
}

TEST_CASE("POV-Ray is given declarations", "[povray]") {
    povray::RunOptions options{.width = 4, .height = 4};
    options.declares = {{"Level", "0.75"}};
    const auto run = povray::run_text(gray_scene, options);
    CHECK(run.picture.pixel(0, 0)[0] == Approx(0.75).margin(8e-6));
}

TEST_CASE("POV-Ray finds includes beside the scene and in library paths", "[povray]") {
    const povray::Scratch folder;
    std::filesystem::create_directory(folder / "with a blank");
    const auto scene = folder / "with a blank/scene.pov";
    image::write_file(folder / "with a blank/beside.inc", "#declare Level = 0.5;\n");
    std::filesystem::create_directory(folder / "library");
    image::write_file(folder / "library/far.inc", "#declare Level = Level/2;\n");
    image::write_file(scene,
                      std::string("#include \"beside.inc\"\n#include \"far.inc\"\n") + gray_scene);
    povray::RunOptions options{.width = 4, .height = 4};
    options.library_paths = {folder / "library"};
    CHECK(povray::run(scene, options).picture.pixel(0, 0)[0] == Approx(0.25).margin(8e-6));
}

TEST_CASE("what POV-Ray takes time for and warns of is handed on", "[povray]") {
    const auto run = povray::run_text(R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 300 }
camera { location -3*z look_at 0 }
light_source { <5, 5, -5> rgb 1 }
sphere { 0, 1 pigment { rgbt 1 } finish { reflection 0.3 } interior { ior 1.5 } }
plane { y, -1 pigment { checker rgb 1 rgb 0 } finish { reflection 0.3 } }
#warning "mind the step"
)",
                                      {.width = 200, .height = 150});
    REQUIRE(run.warnings.size() == 2);
    // wrapped by POV-Ray after "300 was"
    CHECK_THAT(run.warnings[0], Contains("line 2: Parse Warning: Maximum max_trace_level is 256 "
                                         "but 300 was specified"));
    CHECK_THAT(run.warnings[1], Contains("mind the step"));
    CHECK(run.cpu_seconds > 0.0);
    CHECK(run.seconds > 0.0);
    CHECK(run.seconds < 60.0);
}

TEST_CASE("what POV-Ray cannot read is an error in its own words", "[povray]") {
    CHECK_THROWS_WITH(povray::run_text("spere { 0, 1 }\n"),
                      Contains("does not render") && Contains("line 1: Parse Error") &&
                          Contains("undeclared identifier 'spere'") && !Contains("David K. Buck"));
    CHECK_THROWS_AS(povray::run("/tmp/there/is/no/such.pov"), image::FileError);
}

TEST_CASE("without POV-Ray the error says how to get it", "[povray]") {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/there-is-nothing-here", 1);
    try {
        povray::run_text(gray_scene);
        FAIL("an error was expected");
    } catch (const povray::NotInstalled& error) {
        CHECK_THAT(error.what(), Contains("apt-get install povray"));
    }
    setenv("PATH", path.c_str(), 1);
}

TEST_CASE("POV-Ray's console text is understood", "[povray]") {
    const povray::Console console(
        "File 'w.pov' line 3: Parse Warning: Index of refraction value should be\n"
        " specified in 'interior{...}' statement.\n"
        "Parse Warning: assumed_gamma not specified.\n"
        "Parser Time\n"
        "  Parse Time:       0 hours  0 minutes  9 seconds (9.000 seconds)\n"
        "  Trace Time:       0 hours  1 minutes  2 seconds (62.125 seconds)\n"
        "              using 2 thread(s) with 61.500 CPU-seconds total\n");
    CHECK(console.warnings() ==
          std::vector<std::string>{"File 'w.pov' line 3: Parse Warning: Index of refraction value "
                                   "should be specified in 'interior{...}' statement.",
                                   "Parse Warning: assumed_gamma not specified."});
    CHECK(console.seconds() == 62.125);
    CHECK(console.cpu_seconds() == 61.5);
}
