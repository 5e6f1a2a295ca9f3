#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/cli/program.hpp"

namespace {

const std::string small = " -W 16 -H 12 --spp 1 --quiet ";

long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace

TEST_CASE("a render that works is 0 and writes SCENE.png", "[cli]") {
    const Program program;
    const auto result = program.run("render ball.scene" + small);
    CHECK(result.exit_code == 0);
    CHECK(result.out.empty());
    CHECK(result.err.empty());
    CHECK(program.exists("ball.png"));
}

TEST_CASE("wrong options are 2, with one line that names them", "[cli]") {
    const Program program;
    const auto [options, named] = GENERATE(table<std::string, std::string>({
        {"", "no command"},
        {"frobnicate", "frobnicate"},
        {"render", "SCENE"},
        {"render ball.scene --bogus", "--bogus"},
        {"render ball.scene other.scene", "other.scene"},
        {"render ball.scene +X3", "+X3"},
        {"render ball.scene -W 0", "--width"},
        {"render ball.scene -W many", "--width"},
        {"render ball.scene --aa nan", "--aa"},
        {"render ball.scene --aa -1", "--aa"},
        {"render ball.scene --time 0", "--time"},
        {"render ball.scene --spp 4 --grid 2", "--grid"},
        {"render ball.scene --tree oak", "oak"},
        {"render ball.scene --interior dark", "dark"},
        {"inspect ball.scene 1 1 --tree oak", "--tree: 'oak' is not one of whitted, full, sampled"},
        {"inspect ball.scene 1 1 --interior dark", "--interior: 'dark' is not one of"},
        {"render ball.scene --region 0 0 9999 1", "9999"},
        {"render ball.scene --region 0 0 1", "--region"},
        {"render ball.scene --depth 30", "--tree full"},
        {"render ball.scene --cutoff 0.1", "--tree full"},
        {"render ball.scene --bits 12", "12"},
        {"render ball.scene -o picture.jpg", "picture.jpg"},
        {"render ball.scene --half", "--half"},
        {"render ball.scene -o a.exr --layers odd", "odd"},
        {"render ball.scene --layers all", "--layers"},
        {"render ball.scene --declare 5", "--declare"},
        {"render ball.scene --declare 2A=5", "2A"},
        {"render ball.scene -o - --json -", "standard output"},
    }));
    const auto result = program.run(options);
    CAPTURE(options, result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(lines(result.err) == 1);
    CHECK_THAT(result.err, Catch::Contains(named));
}

TEST_CASE("a wrong scene is 2 and shows the place once", "[cli]") {
    const Program program;
    const auto result = program.run("render wrong.scene" + small);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Catch::StartsWith("wrong.scene:1:1: error: "));
    CHECK(result.err.find("error:") == result.err.rfind("error:"));
    CHECK_THAT(result.err, Catch::Contains("^^^^^"));
    CHECK_THAT(result.err, !Catch::Contains("\x1b"));
    CHECK_FALSE(program.exists("wrong.png"));
}

TEST_CASE("files that cannot be read are 3", "[cli]") {
    const Program program;
    program.write("lost.scene", "#include \"absent.inc\"\n");
    for (const std::string scene : {"absent.scene", "lost.scene"}) {
        const auto result = program.run("render " + scene + small);
        CHECK(result.exit_code == 3);
        CHECK_THAT(result.err, Catch::Contains("absent"));
    }
}

TEST_CASE("an unwritable output is 3, before anything is rendered", "[cli]") {
    const Program program;
    // Ten minutes would be spent on it.
    for (const std::string output :
         {"-o absent/a.png", "-o . --format png", "--json absent/a.json"}) {
        const auto result = program.run("render ball.scene --time 600 --quiet " + output);
        CAPTURE(output);
        CHECK(result.exit_code == 3);
        CHECK(lines(result.err) == 1);
    }
    CHECK_FALSE(program.exists("ball.png"));
}

TEST_CASE("a healthy scene passes --strict", "[cli]") {
    CHECK(Program().run("render ball.scene --strict" + small).exit_code == 0);
}

TEST_CASE("Ctrl-C leaves the picture so far and is 130", "[cli]") {
    const Program program;
    // Not before the program catches it: on a busy machine it takes its time to start, and until
    // then the process is the shell's, which catches it too.
    const auto result =
        program.shell("{ " MENISCUS_BINARY
                      " render ball.scene -W 64 -H 48 --time 600 & pid=$!; "
                      "for i in $(seq 3000); do "
                      "grep -q meniscus /proc/$pid/comm && "
                      "grep -q '^SigCgt:.*[2367abef]$' /proc/$pid/status && break; sleep 0.02; "
                      "done; kill -INT $pid; wait $pid; }");
    CAPTURE(result.err);
    CHECK(result.exit_code == 130);
    CHECK(program.exists("ball.png"));
    CHECK_THAT(result.err, Catch::Contains("interrupted"));
}

TEST_CASE("a reader that goes away is a write that fails", "[cli]") {
    const Program program;
    program.shell(
        "{ " MENISCUS_BINARY
        " render ball.scene --spp 1 --quiet --bits 16 -W 800 -o -; echo $? >code; } | true");
    CHECK(program.read("code") == "3\n");
}

TEST_CASE("help and version are data", "[cli]") {
    const Program program;
    for (const std::string options : {"--help", "render --help", "--version"}) {
        const auto result = program.run(options);
        CHECK(result.exit_code == 0);
        CHECK_THAT(result.out, Catch::Contains("meniscus"));
        CHECK(result.err.empty());
    }
}
