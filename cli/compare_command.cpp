#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "cli/command.hpp"
#include "cli/diagnostics.hpp"
#include "cli/scene_comparison.hpp"
#include "cli/shell_words.hpp"
#include "cli/sweep_comparison.hpp"
#include "cli/validators.hpp"
#include "cli/version.hpp"
#include "compare/difference_picture.hpp"
#include "compare/json_report.hpp"
#include "image/save.hpp"

namespace meniscus::cli {
namespace {

struct CompareOptions {
    std::vector<std::string> inputs;  // two pictures, or scenes
    SceneOptions scene{
        .scene = {}, .width = 320, .height = 240, .declarations = {}, .library_paths = {}};
    std::string povray_source, model;
    std::optional<double> gap, scale;
    compare::Settings settings;
    std::optional<double> tolerance;
    int runs = 1;
    std::string output, report, json;
    std::string sweep, csv, svg, markdown;
};

bool is_picture(const std::string& path) {
    return path != image::standard_stream && image::format_of(path).has_value();
}

bool is_within(const compare::Metrics& metrics, const std::optional<double>& tolerance) {
    return !tolerance || (metrics.rmse <= *tolerance && metrics.not_finite == 0);
}

/// What `compare` was told, to be told again.
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
    add({"--threshold", fmt::format("{}", options.settings.threshold)});
    if (options.tolerance) add({"--tolerance", fmt::format("{}", *options.tolerance)});
    if (!options.report.empty()) add({"--report", options.report});
    return command_line(words);
}

compare::Side load_side(const std::string& path, bool& clip) {
    auto loaded = image::load_with_header(path);
    const bool is_png = loaded.format == image::Format::png;
    clip = clip || is_png;
    compare::Side side{
        .name = path, .picture = std::move(loaded.image), .facts = {}, .command = {}};
    side.facts.emplace_back(
        "format",
        is_png ? fmt::format("PNG, {} bits a channel{}", loaded.bits,
                             loaded.bits == 8 ? ": steps of up to 0.009 in linear light" : "")
               : fmt::format("OpenEXR, {}-bit floats", loaded.bits));
    for (const char* key : {"Software", "Scene", "Options", "Tree", "Reproduce"})
        if (const auto found = loaded.metadata.find(key); found != loaded.metadata.end())
            side.facts.emplace_back(key, found->second);
    return side;
}

SceneComparison compare_pictures(const CompareOptions& options) {
    auto settings = options.settings;
    auto reference = load_side(options.inputs[0], settings.clip);
    auto picture = load_side(options.inputs[1], settings.clip);
    SceneComparison result{compare::compare(std::move(reference), std::move(picture), settings),
                           {}};
    result.words.settings = {
        {"values", fmt::format("linear light{}", settings.clip ? ", clipped to [0, 1]" : "")}};
    return result;
}

/// POV-Ray reads its own files as they are; all else is exported.
std::optional<povray::Model> model_of(const CompareOptions& options, const std::string& scene) {
    using enum povray::Model;
    if (options.model == "source") return std::nullopt;
    if (options.model == "plain") return plain;
    if (options.model == "gap") return gap;
    if (options.model == "contact") return contact;
    const bool is_povrays = std::filesystem::path(scene).extension() == ".pov";
    return is_povrays ? std::nullopt : std::optional(contact);
}

SceneComparison compare_scene(const CompareOptions& options, const std::string& scene) {
    SceneComparisonOptions one{
        .scene = options.scene,
        .reference = options.povray_source,
        .model = options.povray_source.empty() ? model_of(options, scene) : std::nullopt,
        .gap = options.gap.value_or(0.0),
        .scale = options.scale,
        .settings = options.settings,
        .runs = options.runs,
        .explain = !options.report.empty()};
    one.scene.scene = scene;
    return compare_scene(one);
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

/// One comparison's outputs; whether it is within the tolerance.
bool report(const CompareOptions& options, SceneComparison& result,
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

void check_usage(const CompareOptions& options) {
    const auto pictures = std::ranges::count_if(options.inputs, is_picture);
    if (pictures > 0 && (pictures != 2 || options.inputs.size() != 2))
        throw UsageError("compare takes two pictures (.png, .exr), or scenes");
    if (pictures > 0 && !options.povray_source.empty())
        throw UsageError("--povray goes with a scene, not with two pictures");
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
    const bool sweeps = !options.sweep.empty();
    if (!sweeps && !(options.csv.empty() && options.svg.empty() && options.markdown.empty()))
        throw UsageError("--csv, --svg and --markdown go with --sweep-gap");
    if (sweeps && !(options.output.empty() && options.report.empty() && options.json.empty() &&
                    !options.tolerance))
        throw UsageError(
            "--sweep-gap writes --csv, --svg and --markdown; -o, --report, --json and --tolerance "
            "do not go with it");
    for (const auto* path : {&options.output, &options.report, &options.json, &options.csv,
                             &options.svg, &options.markdown})
        if (!path->empty()) image::check_writable(*path);
}

/// Each to its file; the table to standard output.
ExitCode run_sweep(const CompareOptions& options) {
    if (options.inputs.size() != 1) throw UsageError("--sweep-gap takes one scene");
    SweepOptions sweep_options{.scene = options.scene,
                               .gapped = options.povray_source,
                               .gaps = parse_gaps(options.sweep),
                               .scale = options.scale,
                               .threshold = options.settings.threshold};
    sweep_options.scene.scene = options.inputs.front();
    const auto sweep = sweep_gaps(sweep_options);
    if (!options.csv.empty()) image::write_file(options.csv, compare::format_csv(sweep));
    if (!options.svg.empty())
        image::write_file(options.svg, compare::draw(compare::make_plot(sweep)));
    if (!options.markdown.empty())
        image::write_file(options.markdown, compare::format_markdown(sweep));
    fmt::print("{}", compare::format_text(sweep));
    return ExitCode::done;
}

ExitCode run(const CompareOptions& options) {
    check_usage(options);
    if (!options.sweep.empty()) return run_sweep(options);
    auto json = compare::Json::array();
    bool good = true;
    if (is_picture(options.inputs.front())) {
        auto result = compare_pictures(options);
        good = report(options, result, options.inputs, json);
    } else {
        for (const auto& scene : options.inputs) {
            if (options.inputs.size() > 1 && options.json != image::standard_stream)
                fmt::print("{}== {}\n", &scene == &options.inputs.front() ? "" : "\n", scene);
            auto result = compare_scene(options, scene);
            good = report(options, result, {scene}, json) && good;
        }
    }
    if (!options.json.empty())
        image::write_file(options.json,
                          compare::dump({{"version", version}, {"comparisons", json}}));
    return good ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

Command make_compare_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "compare", "How far a picture is from another, or from POV-Ray's of the same scene");
    const auto o = std::make_shared<CompareOptions>();
    command
        ->add_option(
            "INPUT", o->inputs,
            "Two pictures (.png, .exr), the reference first; or scenes, to compare with POV-Ray")
        ->required()
        ->type_name("");
    add_scene_settings(*command, o->scene);
    command->add_option("--povray", o->povray_source, "A source of its own for POV-Ray")
        ->type_name("FILE.pov");
    command
        ->add_option("--model", o->model,
                     "What POV-Ray renders: the export as contact (default), gap (films between "
                     "solids, for both) or plain, or the scene as it is (source; default for .pov)")
        ->check(CLI::IsMember({"contact", "gap", "plain", "source"}))
        ->type_name("MODEL");
    command->add_option("--gap", o->gap, "--model gap: the films' thickness in scene units")
        ->check(positive())
        ->type_name("G");
    command
        ->add_option("--scale", o->scale,
                     "Units of the export in one of the scene; default: by the scene's size")
        ->check(positive())
        ->type_name("S");
    command->add_option("--runs", o->runs, "Times are the median of N runs")
        ->check(CLI::Range(1, 1000))
        ->type_name("N");
    command
        ->add_option("--threshold", o->settings.threshold,
                     "A pixel with a channel off by more counts as off")
        ->check(not_negative())
        ->type_name("X")
        ->capture_default_str();
    command->add_option("--tolerance", o->tolerance, "Exit code 4 for an RMSE above it")
        ->check(not_negative())
        ->type_name("RMSE");
    command->add_flag("--clip", o->settings.clip,
                      "Compare values clipped to [0, 1]; implied by PNG and by POV-Ray");
    command->add_option("--worst", o->settings.worst, "Tell so many of the worst pixels")
        ->check(CLI::Range(0, 100))
        ->type_name("N")
        ->capture_default_str();
    command
        ->add_option("-o,--output", o->output,
                     "Save the difference: signed, in colours (.png) or as it is (.exr)")
        ->type_name("DIFF.png|DIFF.exr");
    command
        ->add_option("--report", o->report,
                     "Write an HTML page that shows it all and needs no network")
        ->type_name("OUT.html");
    command->add_option("--json", o->json, "Write the numbers as JSON; - is standard output")
        ->type_name("FILE|-");
    const auto sweep = "Gap";
    command
        ->add_option(
            "--sweep-gap", o->sweep,
            "What a gap between the media costs: for each width both render --model gap, or "
            "--povray's scene with Declare=Gap=WIDTH, beside the scene in contact")
        ->type_name("FROM:TO[:STEPS]")
        ->group(sweep);
    command->add_option("--csv", o->csv, "The sweep's numbers")->type_name("FILE")->group(sweep);
    command->add_option("--svg", o->svg, "The sweep's plot")->type_name("FILE")->group(sweep);
    command->add_option("--markdown", o->markdown, "The sweep's table")
        ->type_name("FILE")
        ->group(sweep);
    return {command, [o] { return run(*o); }};
}

}  // namespace meniscus::cli
