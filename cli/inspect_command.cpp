#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/model_options.hpp"
#include "cli/scene_options.hpp"
#include "cli/validators.hpp"
#include "image/file.hpp"
#include "inspect/diagram.hpp"
#include "inspect/json_report.hpp"
#include "inspect/text_report.hpp"

namespace meniscus::cli {
namespace {

struct InspectOptions {
    SceneOptions scene;
    ModelOptions model;
    int x = 0, y = 0;
    tracer::Options tracer{
        .region = {}, .tree = tracer::Tree::whitted, .instruction_set = {}, .progress = {}};
    std::string svg;  // a file, or "-"
    bool json = false;
};

/// The choices of an option by their own names; CLI11 takes their numbers.
template <class Choice>
CLI::Validator one_of(std::vector<Choice> choices) {
    std::vector<std::string> names;
    for (const Choice choice : choices) names.emplace_back(tracer::name(choice));
    const auto known = fmt::format("{}", fmt::join(names, ", "));
    return {[choices, known](std::string& text) -> std::string {
                for (const Choice choice : choices) {
                    if (text != tracer::name(choice)) continue;
                    text = std::to_string(int(choice));
                    return {};
                }
                return fmt::format("'{}' is not one of {}", text, known);
            },
            fmt::format("{{{}}}", fmt::join(names, "|"))};
}

ExitCode run(InspectOptions options) {
    options.tracer.width = options.scene.width;
    options.tracer.height = options.scene.height;
    if (options.x < 0 || options.y < 0 || options.x >= options.tracer.width ||
        options.y >= options.tracer.height)
        throw UsageError(fmt::format("the pixel {} {} does not lie in a picture of {} x {}",
                                     options.x, options.y, options.tracer.width,
                                     options.tracer.height));
    check_usage(options.model);
    if (options.json && options.svg == image::standard_stream)
        throw UsageError("--json and --svg - cannot both go to standard output");
    options.scene.outputs = {options.svg};

    const auto scene =
        tracer::compile(in_model(read_scene(options.scene).scene, options.model, true));
    const inspect::Names names(scene.source);
    const auto trace = inspect::trace_pixel(scene, names, options.tracer, options.x, options.y);
    if (!options.svg.empty())
        image::write_file(options.svg, inspect::draw_diagram(scene, names, trace));
    if (options.svg == image::standard_stream) return ExitCode::done;
    image::write_file(image::standard_stream,
                      options.json ? inspect::dump(inspect::format_json(scene, names, trace))
                                   : inspect::format_text(scene, names, trace));
    return ExitCode::done;
}

}  // namespace

Command make_inspect_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "inspect", "Show one pixel's ray tree: each crossing, true or false and why");
    const auto options = std::make_shared<InspectOptions>();
    add_scene_options(*command, options->scene);
    add_model_options(*command, options->model);
    command->add_option("X", options->x, "The pixel's column, from 0 at the left")
        ->required()
        ->type_name("");
    command->add_option("Y", options->y, "The pixel's row, from 0 at the top")
        ->required()
        ->type_name("");
    command
        ->add_option("--svg", options->svg,
                     "Draw the tree, seen from the side; - is standard output")
        ->type_name("OUT.svg|-");
    command->add_flag("--json", options->json, "The same as data");

    auto& o = options->tracer;
    using enum tracer::Tree;
    using enum tracer::InteriorMode;
    command->add_option("--tree", o.tree, "Branches of the ray tree; default: whitted")
        ->transform(one_of(std::vector{whitted, full, sampled}))
        ->type_name("TREE")
        ->group("Light");
    command->add_option("--interior", o.interior, "How a ray knows where it is; default: sweep")
        ->transform(one_of(std::vector{sweep, recast, off}))
        ->type_name("MODE")
        ->group("Light");
    command->add_option("--depth", o.depth, "--tree full or sampled: segments of a path")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("N")
        ->group("Light");
    command->add_option("--cutoff", o.cutoff, "--tree full: branches of lower weight are dropped")
        ->check(not_negative())
        ->type_name("WEIGHT")
        ->group("Light");
    command->add_option("--seed", o.seed, "--tree sampled: another path")
        ->type_name("N")
        ->group("Light");
    return {command, [options] { return run(*options); }};
}

}  // namespace meniscus::cli
