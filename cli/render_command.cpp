#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/command.hpp"
#include "cli/diagnostics.hpp"
#include "cli/findings.hpp"
#include "cli/interrupt.hpp"
#include "cli/model_options.hpp"
#include "cli/picture_options.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/scene_options.hpp"
#include "cli/stopwatch.hpp"
#include "cli/tracer_options.hpp"
#include "cli/validators.hpp"
#include "cli/version.hpp"
#include "inspect/check.hpp"
#include "povray/film.hpp"
#include "tracer/render.hpp"

namespace meniscus::cli {
namespace {

struct RenderOptions {
    SceneOptions scene;
    TracerOptions tracer;
    PictureOptions picture;
    std::string json;  // a file, or "-"
    ModelOptions model;
    bool strict = false, quiet = false;
};

/// `--depth` without `--tree full` or `sampled` means the bits of a PNG.
void resolve_depth(RenderOptions& options) {
    const bool has_path_depth = options.tracer.tree == "full" || options.tracer.tree == "sampled";
    const auto depth = options.tracer.depth;
    if (!depth || has_path_depth) return;
    if (depth != 8 && depth != 16)
        throw UsageError(fmt::format(
            "--depth {} of a path needs --tree full or sampled; a PNG has --depth 8 or 16",
            *depth));
    if (options.picture.bits && options.picture.bits != depth)
        throw UsageError(fmt::format("--bits {} and --depth {} contradict each other",
                                     *options.picture.bits, *depth));
    options.picture.bits = depth;
    options.tracer.depth.reset();
}

image::Metadata make_metadata(const Report& report) {
    image::Metadata metadata{
        {"Software", fmt::format("Meniscus {}", version)},
        {"Scene", report.scene},
        {"Options", report.options},
        {"Tree", std::string(name(report.rendered.tree))},
        {"Samples", std::to_string(report.rendered.statistics.samples)},
    };
    std::string reproduce;
    for (const auto& [option, value] : report.rendered.reproduce)
        reproduce += fmt::format("{}--{} {}", reproduce.empty() ? "" : " ", option, value);
    if (!reproduce.empty()) metadata["Reproduce"] = reproduce;
    if (report.rendered.interrupted) metadata["Interrupted"] = "yes";
    return metadata;
}

/// Leaves the layers that are asked for: "depth" means the channel "depth.Z".
void keep_layers(image::Image& picture, const std::vector<std::string>& names) {
    std::erase_if(picture.layers, [&](const image::Layer& layer) {
        const auto name = layer.name.substr(0, layer.name.find('.'));
        return std::ranges::find(names, name) == names.end();
    });
}

ExitCode run(RenderOptions options) {
    resolve_depth(options);
    check_usage(options.model);
    auto target = make_target(options.picture, options.scene.stem());
    auto tracer_options = make_tracer_options(options.tracer, options.scene);
    tracer_options.layers = !target.layers.empty();
    tracer_options.check_segments = options.strict;
    if (target.path == image::standard_stream && options.json == image::standard_stream)
        throw UsageError("the picture and --json cannot both go to standard output");
    options.scene.outputs = {target.path, options.json};

    Stopwatch stopwatch;
    auto interpreted = read_scene(options.scene);
    const auto parse = stopwatch.lap();
    if (interpreted.scene.settings.raw_output && options.picture.encoding.empty())
        target.save.png.encoding = image::Encoding::raw;
    const auto render_scene =
        tracer::compile(in_model(std::move(interpreted.scene), options.model, options.quiet),
                        tracer::hidden_in(tracer_options.interior));
    const auto open_meshes = inspect::check_open_meshes(render_scene);
    for (const auto& warning : as_warnings(open_meshes, options.scene.file_name())) {
        print_diagnostic(lang::format(warning));
        interpreted.warnings.push_back(warning);
    }
    const auto build = stopwatch.lap();

    Progress progress;
    if (!options.quiet) tracer_options.progress = [&](double share) { progress.show(share); };
    const InterruptGuard interrupt;
    tracer_options.interrupted = &interrupt.flag();
    auto rendered = tracer::render(render_scene, tracer_options);
    keep_layers(rendered.picture, target.layers);
    const auto render = stopwatch.lap();
    if (!options.quiet) progress.finish(!rendered.interrupted);

    const Report report{options.scene.file_name(),
                        canonical_options(tracer_options),
                        tracer_options.width,
                        tracer_options.height,
                        parse,
                        build,
                        render,
                        render_scene,
                        rendered,
                        interpreted.warnings};
    image::save(rendered.picture, target.path, target.save, make_metadata(report));
    if (!options.json.empty()) image::write_file(options.json, format_json(report));
    if (!options.quiet) fmt::print(stderr, "{}", format_statistics(report));

    if (rendered.interrupted) {
        print_error("interrupted; the picture so far is saved");
        return ExitCode::interrupted;
    }
    if (options.strict && rendered.statistics.leaks > 0) {
        print_error(fmt::format("{} leaks (--strict)", rendered.statistics.leaks));
        return ExitCode::check_failed;
    }
    return ExitCode::done;
}

}  // namespace

Command make_render_command(CLI::App& app) {
    auto* command = app.add_subcommand("render", "Render a scene to a picture");
    const auto options = std::make_shared<RenderOptions>();
    add_scene_options(*command, options->scene);
    add_picture_options(*command, options->picture);
    add_tracer_options(*command, options->tracer);
    command
        ->add_option("--json", options->json, "Write what was done, as JSON; - is standard output")
        ->type_name("FILE|-");
    add_model_options(*command, options->model);
    command->add_flag("--strict", options->strict,
                      "Check each ray's way through the solids; a leak is exit code 4");
    command->add_flag("--quiet", options->quiet, "No progress, no statistics");
    return {command, [options] { return run(*options); }};
}

}  // namespace meniscus::cli
