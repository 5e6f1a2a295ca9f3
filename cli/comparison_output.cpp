#include "cli/comparison_output.hpp"

#include <fmt/format.h>

#include "cli/version.hpp"
#include "compare/difference_picture.hpp"
#include "image/file.hpp"
#include "image/save.hpp"

namespace meniscus::cli {
namespace {

bool is_within(const compare::Metrics& metrics, const std::optional<double>& tolerance) {
    return !tolerance || (metrics.rmse <= *tolerance && metrics.not_finite == 0);
}

void save_difference(const compare::Comparison& comparison, const std::string& path) {
    image::SaveOptions save;
    save.format = *image::format_of(path);
    const double scale = compare::suggested_scale(comparison);
    const image::Metadata metadata{
        {"Software", fmt::format("Meniscus {}", version)},
        {"Difference", fmt::format("{} - {}", comparison.picture.name, comparison.reference.name)},
        {"Scale", save.format == image::Format::exr ? "linear" : fmt::format("{:g}", scale)}};
    if (save.format == image::Format::exr)
        return image::save(compare::difference_values(comparison), path, save, metadata);
    image::save(compare::difference_map(comparison, scale), path, save, metadata);
    fmt::print(stderr, "{}: blue {:g} and below, white 0, red {:g} and above\n", path, -scale,
               scale);
}

}  // namespace

bool write_comparison(const CompareOptions& options, SceneComparison& result,
                      const std::vector<std::string>& inputs, compare::Json& json) {
    const bool good = is_within(result.comparison.all, options.tolerance);
    if (options.json != image::standard_stream) {
        fmt::print("{}", compare::format_text(result.comparison));
        if (options.tolerance)
            fmt::print("tolerance      {:g}: {}\n", *options.tolerance, good ? "within" : "above");
    }
    json.push_back(compare::to_json(result.comparison));
    if (options.tolerance) json.back()["tolerance"] = *options.tolerance;
    json.back()["within_tolerance"] = good;
    if (!options.output.empty()) save_difference(result.comparison, options.output);
    if (!options.report.empty()) {
        result.words.title = fmt::format("{} against {}", result.comparison.picture.name,
                                         result.comparison.reference.name);
        if (inputs.size() == 1) result.words.title = inputs.front() + ": " + result.words.title;
        result.words.tolerance = options.tolerance;
        result.words.commands.insert(result.words.commands.begin(),
                                     {"This comparison:", own_command_line(options, inputs)});
        image::write_file(options.report, compare::format_report(result.comparison, result.words));
    }
    return good;
}

}  // namespace meniscus::cli
