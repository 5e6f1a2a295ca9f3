#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "image/save.hpp"
#include "tests/cli/program.hpp"

namespace {

/// A glass of water from the side: the water reaches into the wall.
constexpr auto glass_of_water = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { orthographic location <0, 0, -5> look_at 0 right 2*x up 2*y }
background { color rgb 1 }
#declare Glass = lathe {
    linear_spline 7, <0, -1>, <0.9, -1>, <0.9, 1>, <0.7, 1>, <0.7, -0.8>, <0, -0.8>, <0, -1>
    material { ior 1.5 priority 2 }
}
#declare Water = cylinder { <0, -0.9, 0>, <0, 0.5, 0>, 0.8 material { ior 1.33 priority 1 } }
object { Glass }
object { Water }
)";

using Json = nlohmann::json;

}  // namespace

TEST_CASE("inspect tells the lists of a scene in the words of its author", "[inspect]") {
    const Program program;
    program.write("water.scene", glass_of_water);
    const auto result = program.run("inspect water.scene 50 50 -W 101 -H 101 --svg tree.svg");
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    std::size_t at = 0;
    for (const auto* list : {"list: empty\n", "list: Glass\n", "list: Glass, Water\n",
                             "list: Water\n", "list: Water, Glass\n"}) {
        INFO(list);
        at = result.out.find(list, at);
        REQUIRE(at != std::string::npos);
    }
    CHECK(result.out.find("enters Water (water.scene:11), false: Water (priority 1) is below "
                          "Glass (priority 2), which is there") != std::string::npos);
    CHECK(program.read("tree.svg").starts_with("<svg"));

    const auto json =
        Json::parse(program.run("inspect water.scene 50 50 -W 101 -H 101 --json").out);
    CHECK(json.at("pixel") == Json::parse("[50, 50]"));
    CHECK(json.at("segments").at(1).at("crossings").at(0).at("true") == false);
}

TEST_CASE("inspect shows the colour that render gives the pixel", "[inspect]") {
    const Program program;
    program.write("water.scene", glass_of_water);
    const auto json = Json::parse(program.run("inspect water.scene 3 2 -W 8 -H 6 --json").out);
    REQUIRE(program.run("render water.scene --spp 1 -W 8 -H 6 -o water.exr --quiet").exit_code ==
            0);
    const auto picture = meniscus::image::load(program.path("water.exr"));
    CHECK(picture.pixel(3, 2)[0] == Approx(json.at("color").at(0).get<double>()));
}

TEST_CASE("inspect shows light where the scene's numbers are none", "[inspect]") {
    const Program program;
    program.write("gray.scene",
                  "#version 3.7;\nglobal_settings { assumed_gamma 2 }\n"
                  "camera { location -5*z look_at 0 }\nbackground { rgb 0.5 }\n");
    const auto json = Json::parse(program.run("inspect gray.scene 1 1 --json").out);
    CHECK(json.at("color").at(0) == 0.5);
    CHECK(json.at("light").at(0) == 0.25);
    CHECK(program.run("inspect gray.scene 1 1")
              .out.find("colour <0.25, 0.25, 0.25>, linear\n"
                        "  of <0.5, 0.5, 0.5>") != std::string::npos);
}

TEST_CASE("inspect and render agree on the model, films and no priorities", "[inspect]") {
    const Program program;
    program.write("water.scene", glass_of_water);
    for (const std::string model : {"contact", "gap --gap 0.01", "plain"}) {
        INFO(model);
        const auto json = Json::parse(
            program.run("inspect water.scene 6 3 -W 8 -H 6 --json --model " + model).out);
        REQUIRE(
            program
                .run("render water.scene --spp 1 -W 8 -H 6 -o water.exr --quiet --model " + model)
                .exit_code == 0);
        const auto picture = meniscus::image::load(program.path("water.exr"));
        CHECK(picture.pixel(6, 3)[1] == Approx(json.at("color").at(1).get<double>()));
    }
    // Water in the wall is below the glass only where there are priorities.
    const auto tree = [&](const std::string& model) {
        return program.run("inspect water.scene 50 50 -W 101 -H 101 --model " + model).out;
    };
    const std::string film = "Glass's film";
    CHECK(tree("contact").find(film) == std::string::npos);
    CHECK(tree("gap --gap 0.01").find(film) != std::string::npos);
    CHECK(tree("contact").find("is below Glass") != std::string::npos);
    CHECK(tree("plain").find("is below Glass") == std::string::npos);
    CHECK(program.run("inspect water.scene 1 1 --model gap").exit_code == 2);
    CHECK(program.run("inspect water.scene 1 1 --gap 0.1").exit_code == 2);
}

TEST_CASE("inspect refuses a pixel outside the picture", "[inspect]") {
    const Program program;
    const auto result = program.run("inspect ball.scene 640 0");
    CHECK(result.exit_code == 2);
    CHECK(result.err.find("the pixel 640 0 does not lie in a picture of 640 x 480") !=
          std::string::npos);
    CHECK(program.run("inspect ball.scene 1").exit_code == 2);
    CHECK(program.run("inspect missing.scene 1 1").exit_code == 3);
}

TEST_CASE("check finds nothing wrong with a healthy scene", "[inspect]") {
    const Program program;
    program.write("water.scene", glass_of_water);
    const auto result = program.run("check water.scene");
    CHECK(result.exit_code == 0);
    CHECK(result.out == "0 warnings\n");
}

TEST_CASE("check says where and what to do, with exit code 4", "[inspect]") {
    const Program program;
    program.write("tie.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 material { ior 1.5 } }
  sphere { x, 1 material { ior 1.33 } }
sphere { 4*x, 1 pigment { color rgb 1 } interior { ior 1.5 } }
)");
    const auto result = program.run("check tie.scene");
    CHECK(result.exit_code == 4);
    CHECK(result.out.find("tie.scene:5:3: warning: sphere@4 and sphere@5 overlap, as at <") !=
          std::string::npos);
    CHECK(result.out.find("    ^^^^^^\n") != std::string::npos);
    CHECK(result.out.find("tie.scene:4:1: note: sphere@4 is here") != std::string::npos);
    CHECK(result.out.find("to do: give the one that is there a higher priority") !=
          std::string::npos);
    CHECK(result.out.find("material { ior 1.5 }") != std::string::npos);
    CHECK(result.out.find("2 warnings\n") != std::string::npos);

    const auto json = Json::parse(program.run("check tie.scene --json -").out);
    CHECK(json.at("ok") == false);
    REQUIRE(json.at("findings").size() == 2);
    CHECK(json.at("findings").at(0).at("line") == 5);
    CHECK(json.at("findings").at(0).at("lint") == "equal-priority-overlap");
    CHECK(json.at("findings").at(0).at("position").size() == 3);
}

TEST_CASE("a scene that cannot be read is no finding", "[inspect]") {
    const Program program;
    CHECK(program.run("check wrong.scene").exit_code == 2);
    CHECK(program.run("check missing.scene").exit_code == 3);
}

TEST_CASE("check tells of objects that are declared but not in the scene", "[inspect]") {
    const Program program;
    program.write(
        "cup.scene",
        "#declare Cup = sphere { 0, 1 pigment { color rgb 1 } }\ncamera { location -5*z }");
    const auto result = program.run("check cup.scene");
    CHECK(result.exit_code == 4);
    CHECK(result.out.find("cup.scene:1:10: warning: Cup is declared but never used") !=
          std::string::npos);
    CHECK(result.out.find("`object { Cup }`") != std::string::npos);
}
