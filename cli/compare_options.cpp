#include "cli/compare_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_code.hpp"
#include "cli/outputs.hpp"
#include "cli/shell_words.hpp"
#include "image/save.hpp"

namespace meniscus::cli {

bool is_picture(const std::string& path) {
    return path != image::standard_stream && image::format_of(path).has_value();
}

std::string own_command_line(const CompareOptions& options,
                             const std::vector<std::string>& inputs) {
    std::vector<std::string> words = {"meniscus", "compare"};
    const auto add = [&](std::initializer_list<std::string> more) {
        words.insert(words.end(), more);
    };
    words.insert(words.end(), inputs.begin(), inputs.end());
    if (!is_picture(inputs.front())) {
        add({"-W", std::to_string(options.scene.width), "-H",
             std::to_string(options.scene.height)});
        for (const auto& declaration : options.scene.declarations) add({"--declare", declaration});
        for (const auto& path : options.scene.library_paths) add({"-L", path});
        if (!options.povray_source.empty()) add({"--povray", options.povray_source});
        if (!options.model.empty()) add({"--model", options.model});
        if (options.gap) add({"--gap", fmt::format("{}", *options.gap)});
        if (options.scale) add({"--scale", fmt::format("{}", *options.scale)});
    } else if (options.settings.clip) {
        add({"--clip"});
    }
    if (!options.sweep.empty()) add({"--sweep-gap", options.sweep});
    add({"--threshold", fmt::format("{}", options.settings.threshold)});
    if (options.tolerance) add({"--tolerance", fmt::format("{}", *options.tolerance)});
    if (!options.report.empty()) add({"--report", options.report});
    return command_line(words);
}

std::vector<std::string> outputs(const CompareOptions& options) {
    return {options.output, options.report, options.json,
            options.csv,    options.svg,    options.markdown};
}

void check_usage(const CompareOptions& options) {
    const auto pictures = std::ranges::count_if(options.inputs, is_picture);
    if (pictures > 0 && (pictures != 2 || options.inputs.size() != 2))
        throw UsageError("compare takes two pictures (.png, .exr), or scenes");
    if (pictures > 0 && !options.povray_source.empty())
        throw UsageError("--povray goes with a scene, not with two pictures");
    const bool sweeps = !options.sweep.empty();
    if (sweeps && !(options.model.empty() && !options.gap))
        throw UsageError(
            "--sweep-gap tries --model gap with gaps of its own; leave --model and --gap out");
    if ((options.model == "gap") != options.gap.has_value())
        throw UsageError("--model gap and --gap G go together");
    if (!options.povray_source.empty() && !options.model.empty())
        throw UsageError(
            "--povray and --model exclude each other: the one is read, the other exported");
    const bool is_one = pictures == 2 || options.inputs.size() == 1;
    if (!is_one &&
        !(options.output.empty() && options.report.empty() && options.povray_source.empty()))
        throw UsageError("-o, --report and --povray go with one scene at a time");
    if (!options.output.empty() && !is_picture(options.output))
        throw UsageError(fmt::format("'{}' must end in .png or .exr", options.output));
    if (!sweeps && !(options.csv.empty() && options.svg.empty() && options.markdown.empty()))
        throw UsageError("--csv, --svg and --markdown go with --sweep-gap");
    if (sweeps && !(options.output.empty() && options.json.empty() && !options.tolerance))
        throw UsageError(
            "--sweep-gap writes --report, --csv, --svg and --markdown; -o, --json and --tolerance "
            "do not go with it");
    auto inputs = options.inputs;
    inputs.push_back(options.povray_source);
    check_outputs(outputs(options), {inputs.begin(), inputs.end()});
}

}  // namespace meniscus::cli
