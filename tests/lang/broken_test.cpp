#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

namespace fs = std::filesystem;

struct Expectation {
    int line = 0, column = 0;  // column 0: any
    std::string text;          // "..." at its end: what follows may differ
};

/// `// expect error: text` stands on the line of the error, `// expect error 3:1: text` anywhere.
Expectation expectation_of(const std::string& text) {
    static const std::regex pattern("// expect error( (\\d+):(\\d+))?: (.*)");
    std::istringstream in(text);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::smatch m;
        if (!std::regex_search(line, m, pattern)) continue;
        if (m[2].matched) return {std::stoi(m[2]), std::stoi(m[3]), m[4]};
        return {number, 0, m[4]};
    }
    return {};
}

/// The text, cut where the expected one ends in "...".
std::string shortened(const std::string& text, const std::string& expected) {
    if (!expected.ends_with("...")) return text;
    return text.substr(0, expected.size() - 3) + "...";
}

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("every broken scene says what is wrong, and where", "[lang]") {
    std::set<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(MENISCUS_BROKEN_SCENES)) {
        if (entry.path().extension() == ".scene") scenes.insert(entry.path());
    }
    CHECK(scenes.size() >= 60);
    Options options;
    options.limits.loop_steps = 100000;
    for (const auto& path : scenes) {
        CAPTURE(path.filename().string());
        const auto expected = expectation_of(read(path));
        REQUIRE(expected.line > 0);
        bool failed = false;
        try {
            interpret_file(path, options);
        } catch (const SourceError& e) {
            failed = true;
            CHECK(shortened(e.primary().text, expected.text) == expected.text);
            CHECK(e.primary().location.line == expected.line);
            if (expected.column > 0) CHECK(e.primary().location.column == expected.column);
        }
        CHECK(failed);
    }
}

TEST_CASE("an error is printed with its line and carets", "[lang]") {
    try {
        interpret_text("glass.scene", "// a glass\nspere { <0, 0, 0>, 1 }\n");
        FAIL("no error");
    } catch (const SourceError& e) {
        CHECK(format(e) ==
              "glass.scene:2:1: error: unknown object 'spere'; did you mean 'sphere'?\n"
              "    spere { <0, 0, 0>, 1 }\n"
              "    ^^^^^\n");
    }
    CHECK(printed_error("\tsphere { 0, B }") ==
          "test.scene:1:14: error: unknown name 'B'\n"
          "    \tsphere { 0, B }\n"
          "    \t            ^\n");
    CHECK(
        printed_error("\x1b[2J") ==
        "test.scene:1:1: error: expected an object, a directive or the end of the file, found the "
        "byte 0x1B\n"
        "    ?[2J\n"
        "    ^\n");
}

}  // namespace meniscus::lang::test
