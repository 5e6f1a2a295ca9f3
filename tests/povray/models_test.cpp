// Each file in models/ is a scene with priorities; it is exported, rendered by POV-Ray, and
// compared with our own picture at pixel centres. Its first lines say by which models, how near the
// pictures must be away from edges, how many pixels may be off by more than 0.01 in all, and why:
//     // expect contact rmse 5e-5, off 0.3 %: POV-Ray looks for the roots of a lathe to 1e-4 only
//     // expect gap 1e-3 rmse 1e-5, off 0 %: both renderers are given the same films

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>

#include "lang/interpret.hpp"
#include "povray/export.hpp"
#include "povray/film.hpp"
#include "povray/run.hpp"
#include "tests/povray/difference.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

constexpr int width = 160, height = 120;

struct Expectation {
    povray::Model model;
    double gap, rmse, percent_off;
    std::string text;
};

std::vector<Expectation> expectations(const std::filesystem::path& path) {
    std::vector<Expectation> result;
    std::ifstream file(path);
    const std::regex pattern(
        "// expect (plain|contact|gap ([0-9.e-]+)) rmse ([0-9.e-]+), off ([0-9.]+) %: .+");
    std::smatch match;
    for (std::string line; std::getline(file, line) && std::regex_match(line, match, pattern);) {
        const auto model = match[1] == "plain"     ? povray::Model::plain
                           : match[1] == "contact" ? povray::Model::contact
                                                   : povray::Model::gap;
        result.push_back({model, match[2].matched ? std::stod(match[2]) : 0.0, std::stod(match[3]),
                          std::stod(match[4]), match[1]});
    }
    return result;
}

image::Image render(const scene::Scene& scene) {
    tracer::Options options;
    options.width = width;
    options.height = height;
    options.sampling = tracer::GridSampling{1};
    const auto rendered = tracer::render(tracer::compile(scene), options);
    CHECK(rendered.statistics.leaks == 0);
    return rendered.picture;
}

void check(const std::filesystem::path& path, const Expectation& expected) {
    lang::Options reading;
    reading.image_width = width;
    reading.image_height = height;
    const auto scene = lang::interpret_file(path, reading).scene;
    const auto exported = povray::export_scene(
        scene, {.model = expected.model, .gap = expected.gap, .scale = {}, .source = ""});
    const auto theirs = povray::run_text(exported.text, {.width = width, .height = height});
    CHECK(theirs.warnings.empty());
    const bool has_films = expected.model == povray::Model::gap;
    const auto ours = render(has_films ? povray::with_films(scene, expected.gap).scene : scene);
    const auto difference = test::difference_off_edges(theirs.picture, ours);
    INFO(path.stem().string() << ", " << expected.text << ": " << difference.text());
    CHECK(difference.rmse <= expected.rmse);
    CHECK(100.0 * difference.share_off <= expected.percent_off);
}

}  // namespace

TEST_CASE("exported scenes look in POV-Ray as they do here", "[povray]") {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(MODELS_FOLDER)) {
        if (entry.path().extension() == ".scene") paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    REQUIRE(paths.size() >= 25);
    for (const auto& path : paths) {
        const auto all = expectations(path);
        INFO(path.filename() << " must begin with lines '// expect MODEL rmse R, off P %: reason'");
        REQUIRE(!all.empty());
        for (const auto& expected : all) {
            DYNAMIC_SECTION(path.stem().string() << ", " << expected.text) {
                check(path, expected);
            }
        }
    }
}

// The hand-written sources cut the lower solids by a gap; at a scale of 1 POV-Ray loses films of
// 1e-4, so theirs are of 1e-3.
TEST_CASE("hand-written gaps and our films look the same", "[povray]") {
    constexpr double gap = 1e-3;
    const struct {
        const char* name;
        double rmse, percent_off;
    } cases[] = {{"spheres", 3e-4, 0.3}, {"tumbler", 2e-3, 0.3}};
    for (const auto& [name, rmse, percent_off] : cases) {
        DYNAMIC_SECTION(name) {
            const auto folder = std::filesystem::path(BENCH_FOLDER);
            povray::RunOptions options{.width = width, .height = height};
            options.declares = {{"GAP", "1e-3"}};
            const auto theirs = povray::run(folder / (std::string(name) + ".pov"), options).picture;
            lang::Options reading;
            reading.image_width = width;
            reading.image_height = height;
            reading.declares = {{"Gap", "1e-3"}};
            const auto scene =
                lang::interpret_file(folder / (std::string(name) + ".scene"), reading).scene;
            const auto ours = render(povray::with_films(scene, gap).scene);
            const auto difference = test::difference_off_edges(theirs, ours);
            INFO(difference.text());
            CHECK(difference.rmse <= rmse);
            CHECK(100.0 * difference.share_off <= percent_off);

            const auto exported = povray::export_scene(
                scene, {.model = povray::Model::gap, .gap = gap, .scale = {}, .source = ""});
            const auto again = povray::run_text(exported.text, {.width = width, .height = height});
            CHECK(test::difference_off_edges(again.picture, ours).rmse <= rmse);
        }
    }
}

// Off by more than 0.01 are 0.75 % of the pixels, all in the rim and the heel of the glass, where
// light is totally reflected again and again; the glass alone, without anything in
// it, differs as much (1.1 %). Which of the two renderers is off there is not known.
TEST_CASE("the paper's glass of water, in contact, looks the same in POV-Ray", "[povray]") {
    check(std::filesystem::path(EXAMPLES_FOLDER) / "glass_of_water.scene",
          {povray::Model::contact, 0.0, 5e-5, 0.9, "contact"});
}

TEST_CASE("POV-Ray reads the export of every example without a warning", "[povray]") {
    for (const auto& entry : std::filesystem::directory_iterator(EXAMPLES_FOLDER)) {
        if (entry.path().extension() != ".scene") continue;
        const auto scene = lang::interpret_file(entry.path()).scene;
        for (const auto model :
             {povray::Model::plain, povray::Model::contact, povray::Model::gap}) {
            INFO(entry.path().filename() << ", model " << int(model));
            const auto exported = povray::export_scene(
                scene, {.model = model, .gap = 1e-3, .scale = {}, .source = ""});
            const auto run = povray::run_text(exported.text, {.width = 8, .height = 6});
            CHECK(run.warnings.empty());
        }
    }
}
