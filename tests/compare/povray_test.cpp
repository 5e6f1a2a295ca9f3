#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.hpp"

using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// Both renderers read it.
constexpr auto glass_ball = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0, 0, -4> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
plane { y, -1.5 pigment { checker color rgb 0.9 color rgb 0.2 } finish { ambient 1 diffuse 0 } }
sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy } interior { ior Ior } }
)";

/// gap -> POV-Ray against the film, against contact; Meniscus against contact.
std::map<double, std::array<double, 3>> read_sweep(const std::string& csv) {
    std::istringstream lines(csv);
    std::map<double, std::array<double, 3>> rmse;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::array<double, 9> cells{};
        std::istringstream words(line);
        for (double& cell : cells) {
            words >> cell;
            words.get();
        }
        rmse[cells[0]] = {cells[1], cells[3], cells[5]};
    }
    return rmse;
}

}  // namespace

TEST_CASE("compare measures a scene against POV-Ray's picture of it", "[compare]") {
    const Program program;
    program.write("ball.pov", glass_ball);
    const auto result = program.run(
        "compare ball.pov -W 80 -H 60 --declare Ior=1.5 --json - --report r.html --tolerance 1e-4");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const auto comparison = Json::parse(result.out).at("comparisons").at(0);
    // POV-Ray's values come in steps of 1/65535.
    CHECK(comparison.at("all").at("rmse") < 1e-4);
    // The ball's disc has a radius of 60 * tan(asin(1/4)) = 15.5 pixels; the checks seen in it are
    // edges.
    CHECK(comparison.at("regions").at("inside glass").at("pixels") > 10);
    CHECK(comparison.at("regions").at("inside glass").at("pixels") < 755);
    CHECK(comparison.at("reference").at("name") == "POV-Ray");
    CHECK_THAT(comparison.at("reference").at("command").get<std::string>(),
               Contains("povray") && Contains("Declare=Ior=1.5") && Contains("+W80"));
    CHECK(comparison.at("reference").at("facts").contains("CPU seconds of the trace stage"));
    CHECK_THAT(program.read("r.html"), Contains("meniscus inspect ball.pov") && Contains("+SC"));
}

TEST_CASE("compare takes another source for POV-Ray and sees the difference", "[compare]") {
    const Program program;
    program.write("ball.pov", glass_ball);
    program.write("other.pov", "#declare Ior = 1.6;\n" + std::string(glass_ball));
    const auto result =
        program.run("compare ball.scene --povray other.pov -W 40 -H 30 --tolerance 1e-3");
    INFO(result.err);
    CHECK(result.exit_code == 4);
}

TEST_CASE("compare passes POV-Ray's own words on", "[compare]") {
    const Program program;
    program.write("bad.pov", "sphere { 0, 1 nonsense }\n");
    const auto result = program.run("compare ball.scene --povray bad.pov -W 8 -H 6");
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("POV-Ray does not render bad.pov") && Contains("nonsense"));
}

TEST_CASE("a sweep finds where POV-Ray's gap breaks and Meniscus' does not", "[compare]") {
    const Program program;
    const std::string scenes = SCENES_FOLDER;
    const auto result =
        program.run("compare " + scenes + "/glass.scene --povray " + scenes +
                    "/glass_with_a_gap.pov -W 48 -H 36 --sweep-gap 1e-2:1e-6 --csv s.csv "
                    "--svg s.svg --markdown s.md");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    auto rmse = read_sweep(program.read("s.csv"));
    REQUIRE(rmse.size() == 6);
    // POV-Ray ignores hits nearer than 1e-4: a wider film it renders, a thinner one it misses.
    CHECK(rmse.at(1e-2)[0] < 0.02);
    CHECK(rmse.at(1e-6)[0] > 3.0 * rmse.at(1e-2)[0]);
    // A film of air is another picture than contact, however thin; no film is contact itself.
    CHECK(rmse.at(1e-6)[2] > 0.02);
    CHECK(rmse.at(0.0)[2] < 1e-6);
    CHECK_THAT(program.read("s.svg"), Contains("<svg"));
    CHECK_THAT(program.read("s.md"), Contains("| 1e-06 |"));
}

TEST_CASE("a sweep of the paper's glass: films of air, the cliff, and contact at a gap of 0",
          "[compare]") {
    const Program program;
    const auto result = program.run(
        std::string("compare ") + SCENES_FOLDER +
        "/the_papers_glass.scene -W 30 -H 40 --scale 1 --sweep-gap 1e-3:1e-5 --csv s.csv");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    auto rmse = read_sweep(program.read("s.csv"));
    REQUIRE(rmse.size() == 4);
    // POV-Ray renders a film ten times wider than the 1e-4 within which it sees no second hit, and
    // not one ten times thinner.
    CHECK(rmse.at(1e-5)[0] > 5.0 * rmse.at(1e-3)[0]);
    // The film is another picture than contact for both.
    CHECK(rmse.at(1e-3)[1] > 0.05);
    CHECK(rmse.at(1e-5)[2] > 0.05);
    // Films of no thickness are not there, though glass, water, ice and floor all coincide with
    // theirs.
    CHECK(rmse.at(0.0)[2] < 1e-4);
}

TEST_CASE("a sweep hands declarations and library paths to POV-Ray, too", "[compare]") {
    const Program program;
    program.write("ball.pov", glass_ball);
    std::filesystem::create_directory(program.path("library"));
    program.write("library/ball.inc", glass_ball);
    program.write("gap.pov", "#include \"ball.inc\"\n");
    const std::string sweep = "compare ball.pov --povray gap.pov -W 8 -H 6 --sweep-gap 1e-2:1e-3 ";
    const auto result = program.run(sweep + "--declare Ior=1.5 -L library --csv s.csv");
    INFO(result.err);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, !Contains("no picture"));
    CHECK(read_sweep(program.read("s.csv")).at(1e-2)[1] < 1e-3);
}

TEST_CASE("a sweep without a picture of POV-Ray's fails", "[compare]") {
    const Program program;
    program.write("gap.pov", "#version 3.7;\n#ifndef (Meniscus) nonsense #end\n");
    const auto result =
        program.run("compare ball.scene --povray gap.pov -W 8 -H 6 --sweep-gap 1e-2:1e-3");
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("POV-Ray does not render gap.pov") && Contains("nonsense"));
}

TEST_CASE("a sweep tells of widths at which POV-Ray's limits are in the picture", "[compare]") {
    const Program program;
    program.write("nest.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 right x * image_width / image_height }
sphere { 0, 1 material { ior 1.5 priority 1 } }
sphere { 0, 0.8 material { ior 1.33 priority 2 } }
)");
    // A film of 1e-9 that shadow rays see asks for a scale at which 1e7 of POV-Ray's units end
    // before the scene does.
    const auto result =
        program.run("compare nest.scene -W 8 -H 6 --sweep-gap 1e-2:1e-9 --csv s.csv");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const std::string warning = "sees nothing farther than 1;";
    CHECK_THAT(result.err, Contains("warning: gap 1e-09: ") && Contains(warning) &&
                               !Contains("gap 0.01: ") && !Contains("gap 0: "));
    CHECK(result.err.find(warning) == result.err.rfind(warning));
    CHECK_THAT(result.out, Contains(warning));
    CHECK_THAT(program.read("s.csv"), Contains(warning));
}

TEST_CASE("a nested scene is exported and its picture matched", "[compare]") {
    const Program program;
    program.write("nest.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0, 0, -4> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
plane { y, -1.5 pigment { checker color rgb 0.9 color rgb 0.2 } finish { ambient 1 diffuse 0 } }
sphere { 0, 1 material { ior 1.5 priority 1 } }
sphere { 0, 0.8 material { ior 1.33 priority 2 } }
)");
    const auto outside_edges = [&](const std::string& model) {
        const auto result = program.run("compare nest.scene -W 80 -H 60 --json - --model " + model);
        INFO(result.err);
        REQUIRE(result.exit_code == 0);
        return Json::parse(result.out)
            .at("comparisons")
            .at(0)
            .at("regions")
            .at("inside glass")
            .at("rmse")
            .get<double>();
    };
    // POV-Ray's values come in steps of 1/65535.
    CHECK(outside_edges("contact") < 1e-4);
    CHECK(outside_edges("gap --gap 1e-3") < 1e-4);
    // As `export` says them.
    CHECK_THAT(program.run("compare nest.scene -W 8 -H 6 --model gap --gap 1e-3").out,
               Contains("Meniscus: films 0.001 to 0.001 scene units thick"));
}

TEST_CASE("a report traces what each side is given", "[compare]") {
    const Program program;
    program.write("overlap.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0, 0, -4> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
plane { y, -1.5 pigment { checker color rgb 0.9 color rgb 0.2 } finish { ambient 1 diffuse 0 } }
sphere { 0, 1 material { ior 1.5 priority 2 } }
sphere { 0.7*x, 0.8 material { ior 1.33 priority 1 } }
)");
    const auto report = [&](const std::string& model) {
        const auto result =
            program.run("compare overlap.scene -W 40 -H 30 --report r.html --model " + model);
        INFO(result.err);
        REQUIRE(result.exit_code == 0);
        return program.read("r.html");
    };
    // The command of the page makes the tree of the page.
    const auto is_there = [&](const std::string& page, const std::string& model) {
        const auto begin = page.find("inspect overlap.scene");
        REQUIRE(begin != page.npos);
        const auto command = page.substr(begin, page.find('<', begin) - begin);
        CHECK_THAT(command, Contains(model));
        const auto tree = program.run(command);
        CHECK(tree.exit_code == 0);
        CHECK_THAT(page,
                   Contains("<pre tabindex=\"0\">" + tree.out.substr(0, tree.out.find('\n'))));
        return tree.out;
    };
    is_there(report("contact"), "");
    CHECK_THAT(is_there(report("gap --gap 1e-3"), "--model gap --gap 0.001"), Contains("'s film"));
    const auto plain = report("plain");
    CHECK_THAT(plain, Contains("The ray tree of Meniscus") &&
                          Contains("The ray tree without priorities") && Contains("--model plain"));
    CHECK_THAT(report("contact"), !Contains("without priorities"));
}
