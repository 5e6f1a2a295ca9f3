#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using nlohmann::json;

TEST_CASE("option --json tells what was done", "[cli]") {
    const Program program;
    const auto result =
        program.run("render ball.scene -W 16 -H 12 --spp 1 --quiet --json - -o a.png");
    REQUIRE(result.exit_code == 0);
    const auto report = json::parse(result.out);
    CHECK(report.at("rays").at("camera") == 16 * 12);
    for (const auto* kind : {"reflected", "refracted", "shadow"})
        CHECK(report.at("rays").at(kind).is_number_unsigned());
    CHECK(report.at("casts") >= 16 * 12);
    CHECK(report.at("crossings").at("true").is_number_unsigned());
    CHECK(report.at("crossings").at("false") == 0);
    CHECK(report.at("leaks") == 0);
    for (const auto* stage : {"parse", "build", "render"}) {
        CHECK(report.at("seconds").at(stage) >= 0.0);
        CHECK(report.at("cpu_seconds").at(stage) >= 0.0);
    }
    CHECK(report.at("peak_bytes") > 1000000);
    CHECK(report.at("skipped").is_array());
    CHECK(report.at("warnings") == json::array());
    CHECK(report.at("version").is_string());
    CHECK(report.at("tree") == "whitted");
    CHECK(report.at("samples") == 16 * 12);
    CHECK_THAT(report.at("options").get<std::string>(), Catch::Contains("--grid 1"));
}

TEST_CASE("option --json FILE leaves standard output empty", "[cli]") {
    const Program program;
    CHECK(program.run("render ball.scene -W 8 -H 8 --spp 1 --json a.json").out.empty());
    CHECK(json::parse(program.read("a.json")).contains("rays"));
}

TEST_CASE("progress and statistics go to standard error", "[cli]") {
    const Program program;
    const auto result = program.run("render ball.scene -W 64 -H 48 --spp 4");
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Catch::Contains("100 %") && Catch::Contains("leaks") &&
                               Catch::Contains("tree sampled"));
    CHECK_THAT(result.err, !Catch::Contains("\x1b"));
}

TEST_CASE("the tree follows from the sampling", "[cli]") {
    const Program program;
    const auto [options, tree] = GENERATE(table<std::string, std::string>({
        {"--spp 1", "whitted"},
        {"--grid 2", "whitted"},
        {"+A0.3", "whitted"},
        {"--spp 2", "sampled"},
        {"--aa 0.1", "sampled"},
        {"--spp 2 --tree full", "full"},
    }));
    const auto result =
        program.run("render ball.scene -W 8 -H 8 --quiet -o a.png --json - " + options);
    CAPTURE(options, result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(json::parse(result.out).at("tree") == tree);
}

TEST_CASE("option --declare reaches the scene", "[cli]") {
    const Program program;
    program.write("gray.scene", "#version 3.7;\nbackground { color rgb Level }\n");
    CHECK(
        program.run("render gray.scene -W 2 -H 2 --spp 1 --quiet --declare Level=0.5").exit_code ==
        0);
    CHECK(program.run("render gray.scene -W 2 -H 2 --spp 1 --quiet Declare=Level=0.5").exit_code ==
          0);
    CHECK(program.run("render gray.scene -W 2 -H 2 --spp 1 --quiet").exit_code == 2);
}

TEST_CASE("option -L is where included files are looked for", "[cli]") {
    const Program program;
    std::filesystem::create_directory(program.path("parts"));
    program.write("parts/sky.inc", "background { color rgb 0.5 }\n");
    program.write("sky.scene", "#version 3.7;\n#include \"sky.inc\"\n");
    CHECK(program.run("render sky.scene -W 2 -H 2 --spp 1 --quiet -L parts").exit_code == 0);
    CHECK(program.run("render sky.scene -W 2 -H 2 --spp 1 --quiet +Lparts").exit_code == 0);
    CHECK(program.run("render sky.scene -W 2 -H 2 --spp 1 --quiet").exit_code == 3);
}

TEST_CASE("a mesh with a hole is named when it is rendered, with its open edges", "[cli]") {
    const Program program;
    program.write("hole.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
#declare Tent = mesh {
    triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
    triangle { <0, 0, 0>, <0, 0, 1>, <1, 0, 0> }
    triangle { <0, 0, 0>, <0, 1, 0>, <0, 0, 1> }
    material { ior 1.5 }
}
object { Tent }
)");
    const auto result = program.run("render hole.scene -W 16 -H 12 --spp 1 --json - --strict");
    CHECK(result.exit_code == 0);  // it is no leak
    const auto report = json::parse(result.out);
    CHECK(report.at("leaks") == 0);
    REQUIRE(report.at("warnings").size() == 1);
    const auto& warning = report.at("warnings").at(0);
    CHECK(warning.at("line") == 11);
    const auto text = warning.at("text").get<std::string>();
    CHECK_THAT(text, Catch::Contains("Tent is not closed: 3 boundary edges"));
    CHECK_THAT(result.err, Catch::Contains("hole.scene:11:1: warning: " + text));
}

TEST_CASE("leaks are told by object and kind, with the first places, and --strict fails", "[cli]") {
    const Program program;
    // Water that touches glass: the paper's own method swallows one of the two crossings.
    program.write("touch.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, -5> look_at 0 right x * image_width / image_height angle 40 }
background { color rgb <0.2, 0.5, 0.9> }
#declare Glass = box { <-1, -1, -1>, <1, 0, 1> material { ior 1.5 priority 2 } }
#declare Water = box { <-1, 0, -1>, <1, 1, 1> material { ior 1.33 priority 1 } }
object { Glass }
object { Water }
)");
    const std::string render = "render touch.scene -W 32 -H 24 --spp 1 --json - --interior ";
    const auto result = program.run(render + "recast --strict");
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::Contains("leaks (--strict)"));
    const auto report = json::parse(result.out);
    REQUIRE(report.at("leaks") > 10);
    std::uint64_t sum = 0;
    for (const auto& entry : report.at("leaks_by_object")) {
        CHECK((entry.at("object") == "Glass" || entry.at("object") == "Water"));
        CHECK((entry.at("line") == 7 || entry.at("line") == 8));
        CHECK_FALSE(entry.at("kind").get<std::string>().empty());
        sum += entry.at("count").get<std::uint64_t>();
    }
    CHECK(sum == report.at("leaks"));
    CHECK(report.at("first_leaks").size() == 10);
    for (const auto& leak : report.at("first_leaks")) {
        REQUIRE(leak.at("position").size() == 3);
        CHECK_FALSE(leak.at("kind").get<std::string>().empty());
        // On the boxes, or where rays come from.
        for (const auto& coordinate : leak.at("position"))
            CHECK(std::abs(coordinate.get<double>()) <= 5.0);
    }
    CHECK(program.run(render + "recast").exit_code == 0);  // told, not refused
    const auto exact = program.run(render + "sweep --strict");
    CHECK(exact.exit_code == 0);
    CHECK(json::parse(exact.out).at("leaks") == 0);
}
