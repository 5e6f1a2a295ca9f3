#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using Catch::Contains;
using Json = nlohmann::json;

namespace {

constexpr auto tiny = " -W 24 -H 18 --no-povray --quick --spp 2,8 --aa 0.05 --reference-spp 32";

}  // namespace

TEST_CASE("bench measures run time against error", "[bench]") {
    const Program program;
    program.write("checks.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
plane { y, -1.5 pigment { checker color rgb 0.9 color rgb 0.2 } finish { ambient 1 diffuse 0 } }
sphere { 0, 1 material { ior 1.5 } }
)");
    const auto result = program.run(
        std::string("bench checks.scene") + tiny +
        " --modes sweep,recast --runs 2 --csv b.csv --svg b.svg --report b.html --json b.json");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.out, Contains("Meniscus, contact, recast") && Contains("--spp 8"));
    CHECK_THAT(result.err, Contains("reference") && Contains("run 2"));
    CHECK_THAT(program.read("b.csv"), Contains("scene,width") && Contains("--aa 0.05"));
    CHECK_THAT(program.read("b.svg"), Contains("<svg"));
    CHECK_THAT(program.read("b.html"), Contains("meniscus bench checks.scene -W 24 -H 18"));

    const auto benchmark = Json::parse(program.read("b.json")).at("benchmarks").at(0);
    CHECK(benchmark.at("references").at("contact").at("samples") == 64);
    const auto row = [&](const std::string& curve, const std::string& options) {
        for (const auto& row : benchmark.at("rows"))
            if (row.at("curve") == curve && row.at("options") == options) return row;
        return Json();
    };
    const auto few = row("Meniscus, contact", "--spp 2"),
               many = row("Meniscus, contact", "--spp 8");
    CHECK(few.at("samples") == 24 * 18 * 2);
    CHECK(few.at("rays").at("camera") == 24 * 18 * 2);
    CHECK(few.at("runs").size() == 2);
    CHECK(many.at("error").at("rmse") < few.at("error").at("rmse"));
    CHECK(row("Meniscus, contact", "--aa 0.05").at("estimated_error") <= 0.05);
    // One solid: the paper's way gives the very same picture.
    CHECK(row("Meniscus, contact, recast", "--spp 8").at("error").at("rmse").get<double>() ==
          Approx(many.at("error").at("rmse").get<double>()));
    const auto& tasks = benchmark.at("of_equal_tasks");
    CHECK(std::ranges::any_of(tasks, [](const Json& ratio) {
        return ratio.at("at") == "contact, --spp 8" &&
               ratio.at("peer") == "Meniscus, contact, recast";
    }));
}

TEST_CASE("the gap model may be a scene of its own", "[bench]") {
    const Program program;
    const auto benchmark_of = [&](const std::string& words) {
        const auto result = program.run("bench " + words + tiny + " --json -");
        INFO(result.err);
        REQUIRE(result.exit_code == 0);
        return Json::parse(result.out).at("benchmarks").at(0);
    };
    program.write("other.scene", R"(#version 3.7;
background { color rgb <0.2, 0.5, 0.9> }
#ifdef (Wide) sphere { z * 5, Wide material { ior 1.5 } } #end
)");
    const auto gap = benchmark_of(
        "ball.scene --models gap --gap 0.1 --gap-scene other.scene --declare Wide=0.9");
    const auto contact = benchmark_of("other.scene --models contact --declare Wide=0.9");
    CHECK(gap.at("rows").size() == contact.at("rows").size());
    CHECK(gap.at("rows").at(0).at("segments") == contact.at("rows").at(0).at("segments"));
    CHECK(gap.at("rows").at(0).at("error") == contact.at("rows").at(0).at("error"));
    CHECK(gap.at("rows").at(0).at("curve") == "Meniscus, gap");
}

TEST_CASE("bench takes several scenes and keeps data apart from words", "[bench]") {
    const Program program;
    const auto result = program.run(std::string("bench ball.scene ball.scene") + tiny + " --csv -");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.out.starts_with("scene,width,height"));
    CHECK_THAT(result.out, !Contains("on the front of its curve"));
    CHECK(std::ranges::count(result.out, '\n') % 2 == 1);  // a head, and twice the same rows
}

TEST_CASE("Ctrl-C keeps what was measured", "[bench]") {
    const Program program;
    // The reference takes a moment, longer on a busy machine; a picture of 2^20 samples takes for
    // ever. `timeout` sends its signal twice, to the program and to the program's group.
    Json benchmark;
    for (const std::string seconds : {"2", "8", "32"}) {
        const auto result = program.shell("timeout --signal INT " + seconds +
                                          " " MENISCUS_BINARY
                                          " bench ball.scene -W 8 -H 6 --no-povray --quick --spp "
                                          "2,1048576 --reference-spp 2 --json b.json");
        INFO(result.err);
        CHECK_THAT(result.err, Contains("interrupted"));
        benchmark = Json::parse(program.read("b.json")).at("benchmarks").at(0);
        if (!benchmark.at("rows").empty()) break;
    }
    CHECK(benchmark.at("interrupted") == true);
    CHECK(!benchmark.at("rows").empty());
    for (const auto& row : benchmark.at("rows")) CHECK(row.at("options") != "--spp 1048576");
}

TEST_CASE("bench reads all scenes before it measures the first", "[bench]") {
    const Program program;
    const auto result = program.run("bench ball.scene wrong.scene --csv b.csv" + std::string(tiny));
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("wrong.scene:1:1") && !Contains("reference"));
}

TEST_CASE("what bench cannot do gets one clear error", "[bench]") {
    const Program program;
    const auto [arguments, code, words] = GENERATE(table<std::string, int, std::string>({
        {"", 2, "SCENE"},
        {"missing.scene", 3, "missing.scene"},
        {"wrong.scene", 2, "spere"},
        {"ball.scene ball.scene --svg a.svg", 2, "one scene at a time"},
        {"ball.scene --no-povray --povray gap=a.pov", 2, "exclude each other"},
        {"ball.scene ball.scene --gap-scene ball.scene", 2, "one scene at a time"},
        {"ball.scene --gap-scene missing.scene", 3, "missing.scene"},
        {"ball.scene --gap-scene ball.scene --csv ball.scene", 2, "ball.scene"},
        {"ball.scene --povray nonsense=a.pov", 2, "gap=FILE.pov"},
        {"ball.scene --csv - --json -", 2, "standard output"},
        {"ball.scene --csv no/such/folder/a.csv", 3, "no/such/folder"},
        {"ball.scene --modes sweeping", 2, "sweeping"},
        {"ball.scene --aa 0", 2, "0"},
    }));
    CAPTURE(arguments);
    const auto result = program.run("bench " + arguments + " --quick");
    CHECK(result.exit_code == code);
    CHECK_THAT(result.err, Contains(words));
}
