#include "tests/povray/golden.hpp"

#include <algorithm>
#include <fstream>
#include <regex>

#include "lang/interpret.hpp"
#include "povray/film.hpp"
#include "povray/precision.hpp"

namespace meniscus::test {

std::vector<Expectation> expectations(const std::filesystem::path& scene) {
    std::vector<Expectation> result;
    std::ifstream file(scene);
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

std::vector<std::filesystem::path> golden_scenes(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".scene") paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    return paths;
}

scene::Scene read_golden(const std::filesystem::path& path, int width, int height) {
    lang::Options reading;
    reading.image_width = width;
    reading.image_height = height;
    return povray::with_povrays_iors(lang::interpret_file(path, reading).scene);
}

povray::Exported export_golden(const scene::Scene& scene, const Expectation& expectation) {
    return povray::export_scene(
        scene, {.model = expectation.model, .gap = expectation.gap, .scale = {}, .source = ""});
}

tracer::Rendered render_golden(const scene::Scene& scene, const Expectation& expectation, int width,
                               int height, tracer::Kernel kernel) {
    tracer::Options options;
    options.width = width;
    options.height = height;
    options.sampling = tracer::GridSampling{1};
    options.kernel = kernel;
    const bool has_films = expectation.model == povray::Model::gap;
    return tracer::render(
        tracer::compile(has_films ? povray::with_films(scene, expectation.gap).scene : scene),
        options);
}

}  // namespace meniscus::test
