#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/command.hpp"
#include "cli/comparison_output.hpp"
#include "cli/picture_comparison.hpp"
#include "cli/sweep_comparison.hpp"
#include "cli/validators.hpp"
#include "cli/version.hpp"
#include "image/file.hpp"

namespace meniscus::cli {
namespace {

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
    if (!options.report.empty())
        image::write_file(options.report,
                          compare::format_page(sweep, own_command_line(options, options.inputs)));
    fmt::print("{}", compare::format_text(sweep));
    return ExitCode::done;
}

ExitCode run(CompareOptions options) {
    check_usage(options);
    options.scene.outputs = outputs(options);
    if (!options.sweep.empty()) return run_sweep(options);
    auto json = compare::Json::array();
    bool good = true;
    if (is_picture(options.inputs.front())) {
        auto result = compare_pictures(options.inputs[0], options.inputs[1], options.settings);
        good = write_comparison(options, result, options.inputs, json);
    } else {
        for (const auto& scene : options.inputs) {
            if (options.inputs.size() > 1 && options.json != image::standard_stream)
                fmt::print("{}== {}\n", &scene == &options.inputs.front() ? "" : "\n", scene);
            auto result = compare_scene(options, scene);
            good = write_comparison(options, result, {scene}, json) && good;
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
