#include "bench/format.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "tests/bench/rows.hpp"

using namespace meniscus;
using namespace meniscus::bench;
using Catch::Contains;
using test::row;

namespace {

Report report() {
    auto ours = row("Meniscus, gap", 0.025, {0.5, 0.25, 1.0}, "--aa 0.03");
    ours.error.bias = -1e-3;
    ours.estimated_error = 0.02;
    ours.counts.segments = 1000;
    ours.kernel = "general: no, not here";
    ours.counts.samples = 48;
    auto theirs = row("POV-Ray, gap", 0.025, {5.0}, "+A0 \"R\" 3");
    auto broken = row("POV-Ray, gap", 0.0, {}, "-A");
    broken.failure = "it broke";
    auto result = test::result({ours, theirs, broken});
    result.references[Model::gap].rmse = 1e-4;
    mark_fronts(result);
    return make_report(std::move(result), {});
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

}  // namespace

TEST_CASE("CSV has a line for each picture, and quotes what would break it", "[bench]") {
    const auto csv = lines(format_csv({report(), report()}));
    REQUIRE(csv.size() == 5);
    CHECK(
        csv[1] ==
        "glass.scene,4,3,1,\"Meniscus, gap\",--aa 0.03,1,0.025,-0.001,0.0001,0.02,0.5,0.25,1,3,48,"
        "0,0,0,0,0,1000,0,0,5e+05,\"general: no, not here\"");
    CHECK(csv[2] ==
          "glass.scene,4,3,1,\"POV-Ray, gap\",\"+A0 \"\"R\"\" 3\",1,0.025,0,0.0001,,5,5,5,1,"
          ",,,,,,,,,,");
    CHECK(csv[3] == csv[1]);
    const auto commas = [](const std::string& line) {
        bool is_quoted = false;
        int count = 0;
        for (const char c : line) {
            is_quoted = is_quoted != (c == '"');
            count += c == ',' && !is_quoted;
        }
        return count;
    };
    CHECK(commas(csv[0]) == commas(csv[1]));
    CHECK(commas(csv[0]) == commas(csv[2]));
}

TEST_CASE("JSON says the same as CSV, and what failed", "[bench]") {
    const auto json = to_json(report());
    CHECK(json.at("rows").size() == 3);
    CHECK(json.at("rows").at(0).at("cpu_seconds") == 0.5);
    CHECK(json.at("rows").at(0).at("runs").size() == 3);
    CHECK(json.at("rows").at(0).at("error").at("rmse") == 0.025);
    CHECK(json.at("rows").at(0).at("segments") == 1000);
    CHECK(json.at("rows").at(2).at("failure") == "it broke");
    CHECK(json.at("references").at("gap").at("rmse") == 1e-4);
}

TEST_CASE("tables for people name curves, options and failures", "[bench]") {
    CHECK_THAT(format_text(report()), Contains("Meniscus, gap") && Contains("* --aa 0.03") &&
                                          Contains("2.50e-02") && Contains("it broke"));
}

TEST_CASE("the plot has a curve for each, its line along the front", "[bench]") {
    auto result = test::result(
        {row("a", 0.1, {1.0}), row("a", 0.2, {2.0}), row("a", 0.05, {4.0}), row("b", 0.2, {1.0})});
    const auto plot = make_plot(result);
    REQUIRE(plot.series.size() == 2);
    CHECK(plot.series[0].points.size() == 3);
    REQUIRE(plot.series[0].line);
    CHECK(plot.series[0].line->size() == 2);
    // From (1, 0.1) to (4, 0.05); the worse point has a mark and no line.
    const auto svg = compare::draw(plot);
    CHECK_THAT(svg, Contains("<title>a</title><path fill=\"none\""));
}

TEST_CASE("the page shows plot and numbers, and needs no network", "[bench]") {
    const auto page = format_page({report()}, "meniscus bench 'a b.scene' & more");
    CHECK_THAT(page, Contains("<svg") && Contains("glass.scene") && Contains("&amp; more") &&
                         Contains("it broke") && Contains("+A0 &quot;R&quot; 3"));
    CHECK_THAT(page, !Contains("http://") || Contains("http://www.w3.org/2000/svg"));
    CHECK_THAT(page, !Contains("https://") && !Contains(" src="));
}
