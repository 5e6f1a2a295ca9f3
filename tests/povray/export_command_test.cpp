#include <catch2/catch.hpp>

#include "tests/cli/program.hpp"

using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

namespace {

constexpr auto nest = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 right x*image_width/image_height }
background { rgb <0.2, 0.5, 0.9> }
#declare Glass = sphere { 0, 1 material { ior 1.5 priority 1 } }
object { Glass }
sphere { 0, 0.8 material { ior 1.33 priority 2 absorption rgb <0.1, 0.2, 0.3> } }
)";

const std::string head = "camera { location <0, 0, -4> look_at 0 }\n";

}  // namespace

TEST_CASE("export writes the scene's name with .pov, or where it is told", "[export][cli]") {
    const Program program;
    program.write("nest.scene", nest);
    const auto result = program.run("export nest.scene");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains("overlap 1.1e-06 scene units") && Contains("scale 1000"));
    const auto text = program.read("nest.pov");
    CHECK_THAT(text,
               StartsWith("// nest.scene, for POV-Ray 3.7 by Meniscus:\n") && EndsWith("}\n"));

    CHECK(program.run("export nest.scene -o other.pov").exit_code == 0);
    CHECK(program.read("other.pov") == text);
    const auto piped = program.run("export nest.scene --to povray --model contact -o -");
    CHECK(piped.exit_code == 0);
    CHECK(piped.out == text);
}

TEST_CASE("a .pov is not exported over itself: the error says what to do", "[export][cli]") {
    const Program program;
    program.write("nest.pov", nest);
    for (const auto* scene : {"nest.pov", "./nest.pov"}) {
        const auto result = program.run(std::string("export --to povray ") + scene);
        CHECK(result.exit_code == 2);
        CHECK_THAT(result.err,
                   StartsWith("meniscus: error: the export of 'nest.pov' would be 'nest.pov' "
                              "itself: name another file, as -o nest.export.pov"));
        CHECK(program.read("nest.pov") == nest);
    }
    REQUIRE(program.run("export nest.pov -o nest.export.pov").exit_code == 0);
    CHECK_THAT(program.read("nest.export.pov"), StartsWith("// nest.pov, for POV-Ray 3.7"));
    // Nor is what lies elsewhere in the way.
    CHECK(program.shell("mkdir there && cd there && " MENISCUS_BINARY " export ../nest.pov")
              .exit_code == 0);
    CHECK(program.exists("there/nest.pov"));
}

TEST_CASE("an export can be read: names, places, one object a paragraph", "[export][cli]") {
    const Program program;
    program.write("nest.scene", nest);
    const auto text = program.run("export nest.scene -o -").out;
    CHECK_THAT(text, Contains("\n\n// Glass (nest.scene:6), priority 1\n") &&
                         Contains("\n\n// Sphere_7 (nest.scene:7), priority 2\n") &&
                         Contains("#declare Glass =\n") && Contains("interior { ior 1.5 }") &&
                         Contains("media { absorption rgb <0.1, 0.2, 0.3>/S }") &&
                         Contains("interior_texture"));
    CHECK_THAT(text, !Contains("\n\n\n") && !Contains(" \n") && !Contains("\t"));
}

TEST_CASE("the models differ in what stands for the priorities", "[export][cli]") {
    const Program program;
    program.write("nest.scene", nest);
    const auto plain = program.run("export nest.scene --model plain -o -");
    CHECK_THAT(plain.out, Contains("as declared, without its priorities") &&
                              Contains("sphere {\n    <0, 0, 0>, 0.8*S\n") &&
                              !Contains("difference") && !Contains("interior_texture"));
    const auto gap = program.run("export nest.scene --model gap --gap 0.01 -o -");
    CHECK_THAT(gap.out, Contains("// The films are 0.01 thick.") && Contains("0.81*S") &&
                            Contains("difference") && !Contains("interior_texture"));
    CHECK_THAT(gap.err, Contains("films 0.01 to 0.01 scene units thick"));
    const auto alone = program.run("export ball.scene --model gap --gap 0.01 -o -");
    CHECK_THAT(alone.err, Contains("no films: no solid cuts another"));
}

TEST_CASE("a scale that does not fit is warned of", "[export][cli]") {
    const Program program;
    program.write("nest.scene", nest);
    const auto result = program.run("export nest.scene --scale 1 -o nest.pov");
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("meniscus: warning: solids overlap by 0.0011 at --scale 1") &&
                               Contains("use --scale 100 or more"));
}

TEST_CASE("POV-Ray is asked for no deeper tree than it has", "[export][cli]") {
    const Program program;
    const auto exported = [&](int levels) {
        program.write("deep.scene", head + "global_settings { max_trace_level " +
                                        std::to_string(levels) + " }\nsphere { 0, 1 }\n");
        return program.run("export deep.scene -o -");
    };
    CHECK_THAT(exported(256).out, Contains("max_trace_level 256\n"));
    CHECK_THAT(exported(256).err, !Contains("max_trace_level"));
    CHECK_THAT(exported(257).out, Contains("max_trace_level 256\n"));
    CHECK_THAT(exported(257).err,
               Contains("warning: max_trace_level is 256 in the export, not 257"));
}

TEST_CASE("what export cannot do it refuses where it stands", "[export][cli]") {
    const Program program;
    const struct {
        const char *scene, *arguments, *where, *why;
    } cases[] = {
        {"sphere { 0, 1 material { ior 1.5 priority 1 } }\n"
         "sphere { x, 1 material { ior 1.3 priority 1 } }\n",
         "", "s.scene:3:1: error: ", "overlap with the same priority 1"},
        {"sphere { 0, 1 interior { ior 1.5 fade_distance 1 fade_power 2 } }\n", "",
         "s.scene:2:1: error: ", "fade_power below 1000"},
        {"sphere { 0, 1 interior { ior 1.5 caustics 1 } }\n"
         "sphere { 0.5*x, 1 material { ior 1.3 priority 2 } }\n",
         "", "s.scene:2:1: error: ", "caustics"},
        {"sphere { 0, 1 material { ior 1.5 } }\n  disc { 2*y, y, 1 pigment { rgbt 1 } }\n", "",
         "s.scene:3:3: error: ", "open surface that lets light through"},
        {"sphere { 0, 1 material { ior 1.5 priority 1 } no_image }\n"
         "sphere { 0, 0.5 material { ior 1.3 priority 2 } }\n",
         "", "s.scene:2:1: error: ", "no_image"},
        {"sphere { 0, 1 material { ior 1.5 priority 1 } }\n"
         "sphere { 0.9*x, 0.1 material { ior 1.3 priority 2 } }\n"
         "sphere { 1.05*x, 0.01 material { ior 1.4 priority 0 } }\n",
         "--model gap --gap 0", "", "--gap"},
        {"", "--model gap", "meniscus: error: ", "--model gap needs --gap G"},
        {"", "--gap 1e-3", "meniscus: error: ", "--gap belongs to --model gap"},
        {"", "--to rayshade", "", "--to"},
        {"global_settings { interior { ior 1 absorption rgb 0.1 } }\n", "",
         "error: ", "the outside absorbs"},
    };
    for (const auto& c : cases) {
        program.write("s.scene", head + c.scene);
        const auto result = program.run(std::string("export s.scene -o s.pov ") + c.arguments);
        INFO(c.scene << c.arguments << "\n" << result.err);
        CHECK(result.exit_code == 2);
        CHECK_THAT(result.err, Contains(c.where) && Contains(c.why));
        CHECK_FALSE(program.exists("s.pov"));
    }
    // Never over what it reads.
    const std::string before = program.read("ball.scene");
    CHECK(program.run("export ball.scene -o ./ball.scene").exit_code == 2);
    CHECK(program.read("ball.scene") == before);
    CHECK(program.run("export ball.scene -o nowhere/s.pov").exit_code == 3);
    CHECK(program.run("export none.scene").exit_code == 3);
}

TEST_CASE("a curved wall in common that no export cuts cleanly is warned of", "[export]") {
    const Program program;
    const std::string cup = "lathe { linear_spline 4, <0, 0> <1, 0> <1, 1> <0, 1> ";
    program.write("s.scene", head + cup + "material { ior 1.5 priority 2 } }\n" +
                                 "cylinder { 0, 2*y, 1 material { ior 1.33 priority 1 } }\n");
    const auto result = program.run("export s.scene -o s.pov");
    INFO(result.err);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("s.scene:3: ") && Contains("curved outer wall"));
    CHECK(program.exists("s.pov"));
    // A cylinder cuts such a wall cleanly.
    program.write("t.scene", head +
                                 "cylinder { 0, y, 1 material { ior 1.5 priority 2 } }\n"
                                 "cylinder { 0, 2*y, 1 material { ior 1.33 priority 1 } }\n");
    CHECK_THAT(program.run("export t.scene -o t.pov").err, !Contains("curved outer wall"));
}

TEST_CASE("media without an end that absorb are warned of", "[export]") {
    const Program program;
    const std::string absorbing = "material { ior 1.33 absorption rgb <0, 0.5, 1> } }\n";
    const std::string shape = GENERATE("plane { y, -0.5 ", "sphere { 0, 3 inverse ");
    const std::string model = GENERATE("contact", "plain", "gap --gap 1e-3");
    program.write("s.scene", head + shape + absorbing);
    const auto result = program.run("export s.scene -o s.pov --model " + model);
    INFO(result.err);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("s.scene:2: ") && Contains("absorbs and has no end"));
    program.write("t.scene", head + "plane { y, -9 pigment { rgb 1 } }\n" + "plane { y, -0.5 " +
                                 absorbing + "sphere { 0, 3 " + absorbing);
    CHECK_THAT(program.run("export t.scene -o t.pov --model " + model).err, !Contains("no end"));
}

TEST_CASE("a label in the very wall of a glass is warned of", "[export]") {
    const Program program;
    const std::string glass = "cylinder { 0, 2*y, 1 material { ior 1.5 } }\n";
    const std::string model = GENERATE("contact", "plain", "gap --gap 1e-3");
    const auto warnings_of = [&](const std::string& radius) {
        program.write("s.scene", head + glass + "cylinder { 0.5*y, 1.5*y, " + radius +
                                     " open pigment { rgb 1 } }\n");
        const auto result = program.run("export s.scene -o s.pov --model " + model);
        CHECK(result.exit_code == 0);
        return result.err;
    };
    CHECK_THAT(warnings_of("1"), Contains("s.scene:3: ") && Contains("lies in the wall"));
    CHECK_THAT(warnings_of("1.01"), !Contains("lies in the wall"));
    CHECK_THAT(warnings_of("0.9"), !Contains("lies in the wall"));
}

TEST_CASE("an opaque block that ends level with a glass it reaches into is warned of", "[export]") {
    const Program program;
    const std::string glass = "box { -1, 1 material { ior 1.5 } }\n";
    const std::string model = GENERATE("contact", "plain", "gap --gap 1e-3");
    const auto warnings_of = [&](const std::string& block) {
        program.write("s.scene", head + glass + block + " pigment { rgb 1 } }\n");
        const auto result = program.run("export s.scene -o s.pov --model " + model);
        CHECK(result.exit_code == 0);
        return result.err;
    };
    CHECK_THAT(warnings_of("box { 0, <2, 1, 2>"),
               Contains("s.scene:3: ") && Contains("ends level with"));
    CHECK_THAT(warnings_of("box { 0, <2, 0.9, 2>"), !Contains("ends level"));
    CHECK_THAT(warnings_of("box { <1, 0, 0>, <2, 1, 2>"), !Contains("ends level"));
    CHECK_THAT(warnings_of("box { <-3, -3, -3>, <3, -1, 3>"), !Contains("ends level"));
}

TEST_CASE("solids that only contact_tolerance brings together are warned of", "[export]") {
    const Program program;
    const std::string model = GENERATE("contact", "plain", "gap --gap 1e-3");
    const auto warnings = [&](const std::string& tolerance, const std::string& objects) {
        program.write("s.scene", head + "global_settings { " + tolerance + " }\n" + objects);
        const auto result = program.run("export s.scene -o s.pov --model " + model);
        CHECK(result.exit_code == 0);
        return result.err;
    };
    const auto glass = [](double gap, const std::string& other) {
        return "box { <-1, " + std::to_string(gap) +
               ", -1>, 1 material { ior 1.5 priority 2 } }\n" + other;
    };
    const std::string water = "box { -1, <1, 0, 1> material { ior 1.33 priority 1 } }\n";
    const std::string floor = "plane { y, 0 pigment { rgb 1 } }\n";
    const std::string told = "contact_tolerance 1e-3";
    CHECK_THAT(warnings(told, glass(5e-4, water)), Contains("s.scene:4: ") &&
                                                       Contains("are 0.0005 apart") &&
                                                       Contains("contact_tolerance of 0.001"));
    CHECK_THAT(warnings(told, glass(5e-4, floor)),
               Contains("s.scene:3: ") && Contains("are 0.0005 apart"));
    // The lower one sticks out of the higher.
    CHECK_THAT(
        warnings(told,
                 glass(0.0, "box { -0.5, <1.0005, 0.5, 0.5> material { ior 1.33 priority 1 } }\n")),
        Contains("are 0.0005 apart"));
    for (const auto& other : {water, floor}) {
        CHECK_THAT(warnings("", glass(5e-4, other)), !Contains("apart"));
        CHECK_THAT(warnings(told, glass(2e-3, other)), !Contains("apart"));
        CHECK_THAT(warnings(told, glass(0.0, other)), !Contains("apart"));
        CHECK_THAT(warnings(told, glass(-5e-4, other)), !Contains("apart"));
    }
    const bool is_film_narrower = model.starts_with("gap");
    CHECK((warnings("contact_tolerance 2e-3", glass(0.0, water)).find("films of 0.001 are none") !=
           std::string::npos) == is_film_narrower);
}

TEST_CASE("an opaque block that glass cuts is closed by its own texture", "[export]") {
    const Program program;
    const std::string model = GENERATE("contact", "gap --gap 1e-3");
    const std::string glass = "sphere { 0, 1 material { ior 1.5 priority 2 } }\n";
    const std::string red = "pigment { rgb <1, 0.1, 0.2> }", interior = "interior { ior 1.3 }";
    const auto exported = [&](const std::string& block) {
        program.write("s.scene", head + glass + block);
        return program.run("export s.scene -o - --model " + model);
    };
    const auto one = exported("box { 0, 2 " + red + interior + " }\n");
    CHECK_THAT(one.err, !Contains("warning"));
    const auto block = one.out.substr(one.out.find("// Box_3 (s.scene:3), priority 0"));
    CHECK_THAT(block, Contains("Texture_1") && !Contains("Clear"));
    const auto several = exported("union { box { 0, 2 " + red +
                                  " } box { -2, -0.1 pigment { rgb 0.4 } } " + interior + " }\n");
    CHECK_THAT(several.err,
               Contains("warning: s.scene:3: of 'box'") && Contains("get the texture"));
}

TEST_CASE("what is nowhere to be seen is not exported", "[export]") {
    const Program program;
    program.write("s.scene", head +
                                 "sphere { 0, 1 material { ior 1.5 priority 2 } }\n"
                                 "sphere { 0, 1 material { ior 1.33 priority 1 } }\n");
    REQUIRE(program.run("export s.scene -o s.pov").exit_code == 0);
    const std::string text = program.read("s.pov");
    CHECK_THAT(text, Contains("ior 1.5") && !Contains("ior 1.33"));
}
