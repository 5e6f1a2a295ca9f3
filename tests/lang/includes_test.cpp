#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

namespace fs = std::filesystem;

const fs::path standard_includes = "/usr/share/povray-3.7/include";
const fs::path examples = "/usr/share/doc/povray/examples";

}  // namespace

TEST_CASE("all standard includes can be read", "[lang]") {
    if (!fs::exists(standard_includes)) return;
    for (const auto& entry : fs::directory_iterator(standard_includes)) {
        if (entry.path().extension() != ".inc") continue;
        const auto name = entry.path().filename().string();
        if (name == "stage1.inc" || name == "screen.inc")
            continue;  // they put objects of their own into the scene
        CAPTURE(name);
        CHECK(error("#version 3.7; #include \"colors.inc\" #include \"" + name + "\"") == "");
    }
}

TEST_CASE("including a file twice is normal, and another case is found with a warning", "[lang]") {
    if (!fs::exists(standard_includes)) return;
    const auto twice = interpret(
        "#version 3.7; #include \"colors.inc\" #include \"colors.inc\" sphere { 0, 1 pigment { Red "
        "} }");
    CHECK(twice.warnings.empty());
    const auto other =
        interpret("#version 3.7; #include \"Colors.INC\" sphere { 0, 1 pigment { Red } }");
    CHECK(other.warnings.size() == 1);
}

TEST_CASE("POV-Ray's own scenes of the first level are understood", "[lang]") {
    if (!fs::exists(examples)) return;
    for (const auto* name :
         {"interior/iortest.pov", "interior/crystal.pov", "interior/atten1.pov",
          "interior/skysph1.pov", "camera/orthographic.pov", "lights/parallel_lights.pov",
          "incdemo/metals/chromes.pov", "advanced/bwstripe.pov",
          "templates/Basic_Scenes/Checkered_plane.pov", "lights/shadows.pov",
          "language/macros/macro1.pov", "objects/chesmsh.pov"}) {
        CAPTURE(name);
        std::string text;
        try {
            CHECK_FALSE(interpret_file(examples / name).scene.objects.empty());
        } catch (const SourceError& e) {
            text = format(e);
        }
        CHECK(text == "");
    }
}

TEST_CASE("a shared interior over touching members is one solid each in iortest", "[lang]") {
    if (!fs::exists(examples)) return;
    const auto scene = interpret_file(examples / "interior/iortest.pov").scene;
    CHECK(scene.objects.size() == 21);
    CHECK(scene.solids.size() == 7);
}

}  // namespace meniscus::lang::test
