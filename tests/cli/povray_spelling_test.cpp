#include "cli/povray_spelling.hpp"

#include <catch2/catch.hpp>

#include "cli/exit_code.hpp"

using meniscus::cli::translate_povray_spellings;
using meniscus::cli::UsageError;
using Arguments = std::vector<std::string>;

TEST_CASE("POV-Ray's switches become options", "[cli]") {
    const auto translated = translate_povray_spellings(
        {"render", "+Ia.pov", "+W320", "+h240", "+Oout.png", "+WT4", "+Linc", "+SC0.25", "+ER7"});
    CHECK(translated == Arguments{"render", "a.pov", "--width", "320", "--height", "240",
                                  "--output", "out.png", "--threads", "4", "-L", "inc",
                                  "--start-column", "0.25", "--end-row", "7"});
}

TEST_CASE("anti-aliasing keeps POV-Ray's contrast meaning", "[cli]") {
    CHECK(translate_povray_spellings({"+A"}).back() == "0.3");
    CHECK(translate_povray_spellings({"x", "+A0.05", "+R4", "+AM2"}) ==
          Arguments{"x", "--contrast", "0.05", "--contrast-depth", "4", "--contrast-method", "2"});
    CHECK(translate_povray_spellings({"x", "-A"}) == Arguments{"x", "--grid", "1"});
}

TEST_CASE("settings are read in any case", "[cli]") {
    CHECK(translate_povray_spellings({"x", "width=80", "Declare=N=3", "File_Gamma=1.0"}) ==
          Arguments{"x", "--width", "80", "--declare", "N=3", "--encoding", "linear"});
}

TEST_CASE("file types become formats", "[cli]") {
    CHECK(translate_povray_spellings({"x", "+FN16"}) ==
          Arguments{"x", "--format", "png", "--bits", "16"});
    CHECK(translate_povray_spellings({"x", "+FE"}) == Arguments{"x", "--format", "exr"});
    CHECK_THROWS_WITH(translate_povray_spellings({"x", "+FT"}), Catch::Contains("+FT"));
}

TEST_CASE("what changes no picture is dropped", "[cli]") {
    CHECK(translate_povray_spellings({"x", "-D", "+P", "-V", "Display=off"}) == Arguments{"x"});
}

TEST_CASE("a switch alone means render", "[cli]") {
    CHECK(translate_povray_spellings({"+Ia.pov"}) == Arguments{"render", "a.pov"});
}

TEST_CASE("our own options and their values pass untouched", "[cli]") {
    const Arguments ours = {"render",    "a.scene", "-W",  "320", "--declare", "Width=3",
                            "--declare", "A=+5",    "-o",  "-",   "-L",        "+dir",
                            "--json",    "Height=", "x=y", "-"};
    CHECK(translate_povray_spellings(ours) == ours);
}

TEST_CASE("unknown switches are refused by name", "[cli]") {
    CHECK_THROWS_AS(translate_povray_spellings({"render", "+X3"}), UsageError);
    CHECK_THROWS_WITH(translate_povray_spellings({"render", "+MB1"}), Catch::Contains("'+MB1'"));
    CHECK_THROWS_WITH(translate_povray_spellings({"render", "+W"}),
                      Catch::Contains("needs a value"));
}
