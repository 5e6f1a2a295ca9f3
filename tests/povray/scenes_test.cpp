// Each file in scenes/ is read by POV-Ray and by Meniscus as it is, and rendered at pixel centres
// by both. Its first line says how near the pictures must be, and why not nearer:
//     // expect rmse 1e-5: rounding to 16 bits is 4.4e-6
//     // expect rmse 1e-5 but for 1 pixel: a ray that meets the floor 7000 units away
// Where the two languages must differ (POV-Ray knows no priorities, Meniscus no CSG), the file asks
// `#ifdef (Meniscus)`.

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>

#include "lang/interpret.hpp"
#include "povray/run.hpp"
#include "tests/povray/difference.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

constexpr int width = 160, height = 120;

struct Expectation {
    double rmse;
    std::size_t outliers;  // so many of the worst pixels are left out
};

Expectation expectation(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    std::smatch match;
    const std::regex pattern("// expect rmse ([0-9.e-]+)(?: but for ([0-9]) pixels?)?: .+");
    INFO(path.filename() << " must begin with a line '// expect rmse 1e-5: reason'");
    REQUIRE(std::regex_match(line, match, pattern));
    return {std::stod(match[1]), match[2].matched ? std::stoul(match[2]) : 0};
}

std::vector<std::filesystem::path> scenes() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(SCENES_FOLDER)) {
        if (entry.path().extension() == ".pov") paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    return paths;
}

}  // namespace

TEST_CASE("scenes look as POV-Ray renders them", "[povray]") {
    const auto paths = scenes();
    REQUIRE(paths.size() >= 25);
    for (const auto& path : paths) {
        DYNAMIC_SECTION(path.stem().string()) {
            lang::Options reading;
            reading.image_width = width;
            reading.image_height = height;
            reading.declares = {{"Meniscus", "1"}};
            tracer::Options options;
            options.width = width;
            options.height = height;
            options.sampling = tracer::GridSampling{1};
            const auto scene = tracer::compile(lang::interpret_file(path, reading).scene);
            const auto ours = tracer::render(scene, options);
            const auto [rmse, outliers] = expectation(path);
            const auto theirs = povray::run(path, {.width = width, .height = height});
            const auto difference = test::difference(theirs.picture, ours.picture, outliers);
            INFO(difference.text());
            CHECK(difference.rmse <= rmse);
            CHECK(ours.statistics.leaks == 0);
        }
    }
}
