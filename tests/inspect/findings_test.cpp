// Each scene in findings/ shows the rule that it is named after, and no other; docs/checking.md
// shows what `check` says of them.

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using Json = nlohmann::json;

TEST_CASE("each finding has a scene that shows it alone", "[inspect]") {
    const Program program;
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(FINDINGS_FOLDER)) {
        ++scenes;
        CAPTURE(entry.path().filename().string());
        const auto result = program.run("check '" + entry.path().string() + "' --json -");
        const auto json = Json::parse(result.out);
        REQUIRE(json.at("findings").size() == 1);
        const auto& finding = json.at("findings").at(0);
        CHECK(finding.at("lint") == entry.path().stem().string());
        CHECK_THAT(finding.at("file").get<std::string>(),
                   Catch::EndsWith(entry.path().filename().string()));
        CHECK(finding.at("line") > 0);
        CHECK(finding.at("column") > 0);
        CHECK_FALSE(finding.at("advice").get<std::string>().empty());
        CHECK(result.exit_code == (finding.at("severity") == "warning" ? 4 : 0));
    }
    CHECK(scenes >= 15);
}

TEST_CASE("the page about check is up to date", "[inspect]") {
    const Program program;
    const std::string root = PROJECT_FOLDER;
    const auto result =
        program.shell("MENISCUS=" MENISCUS_BINARY " '" + root + "/scripts/checking-page'");
    REQUIRE(result.exit_code == 0);
    CHECK(result.out == meniscus::image::read_file(root + "/docs/checking.md"));
}
