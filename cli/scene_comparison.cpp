#include "cli/scene_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/diagnostics.hpp"
#include "cli/model_options.hpp"
#include "cli/povray_source.hpp"
#include "cli/shell_words.hpp"
#include "compare/jump_regions.hpp"
#include "inspect/diagram.hpp"
#include "inspect/text_report.hpp"
#include "povray/film.hpp"
#include "povray/plain.hpp"
#include "povray/precision.hpp"
#include "povray/run.hpp"
#include "tracer/render.hpp"

namespace meniscus::cli {
namespace {

using compare::Explanation;
using compare::Side;

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

std::string seconds_fact(const std::vector<double>& seconds) {
    return fmt::format(
        "{:.3f}{}", median(seconds),
        seconds.size() > 1 ? fmt::format(" (median of {} runs)", seconds.size()) : "");
}

/// The options that say which picture of a scene it is.
std::vector<std::string> picture_words(const SceneOptions& options) {
    std::vector<std::string> words = {"-W", std::to_string(options.width), "-H",
                                      std::to_string(options.height)};
    for (const auto& declaration : options.declarations)
        words.insert(words.end(), {"--declare", declaration});
    for (const auto& path : options.library_paths) words.insert(words.end(), {"-L", path});
    return words;
}

std::string meniscus_line(std::vector<std::string> words, const SceneOptions& options) {
    words.insert(words.begin(), "meniscus");
    const auto picture = picture_words(options);
    words.insert(words.end(), picture.begin(), picture.end());
    return command_line(words);
}

/// Of our own picture: the scene, or the scene with films.
std::string own_line(std::vector<std::string> words, const SceneComparisonOptions& options) {
    if (options.model == povray::Model::gap)
        words.insert(words.end(), {"--model", "gap", "--gap", fmt::format("{}", options.gap)});
    return meniscus_line(std::move(words), options.scene);
}

struct PovRaySide {
    Side side;
    std::vector<std::string> command;
};

std::string_view name(povray::Model model) {
    using enum povray::Model;
    return model == plain ? "plain" : model == contact ? "contact" : "gap";
}

/// What POV-Ray is to render: a file, or the export of a scene.
struct Source {
    std::string file, text;
    std::string export_command;  // makes `file` of the scene; empty if it is there anyhow
    std::vector<std::string> warnings;
};

Source make_source(const SceneComparisonOptions& options, const scene::Scene& scene) {
    if (!options.reference.empty()) return {options.reference, {}, {}, {}};
    if (!options.model) return {options.scene.scene, {}, {}, {}};
    const auto file = options.scene.stem() + ".pov";
    std::vector<std::string> words = {"export",  options.scene.scene,
                                      "--to",    "povray",
                                      "--model", std::string(name(*options.model)),
                                      "-o",      file};
    if (options.gap > 0.0) words.insert(words.end(), {"--gap", fmt::format("{}", options.gap)});
    if (options.scale) words.insert(words.end(), {"--scale", fmt::format("{}", *options.scale)});
    const auto exported = povray::export_scene(scene, {.model = *options.model,
                                                       .gap = options.gap,
                                                       .scale = options.scale,
                                                       .source = options.scene.file_name()});
    return {file, exported.text, meniscus_line(words, options.scene), exported.warnings};
}

PovRaySide render_by_povray(const SceneComparisonOptions& options, const Source& source) {
    auto run = run_options(options.scene);
    if (!source.text.empty()) {  // the export depends on neither any more
        run.declares.clear();
        run.library_paths.clear();
    }
    std::vector<double> seconds;
    povray::Run result;
    for (int i = 0; i < options.runs; ++i) {
        result = source.text.empty() ? povray::run(source.file, run)
                                     : povray::run_text(source.text, run);
        seconds.push_back(result.cpu_seconds);
    }
    // The picture was taken from standard output, the export from a file of the moment.
    std::ranges::replace(result.command, "+O-", "+Opovray.ppm");
    for (auto& word : result.command)
        if (!source.text.empty() && word.starts_with("+I")) word = "+I" + source.file;
    PovRaySide povray{{.name = "POV-Ray",
                       .picture = std::move(result.picture),
                       .facts = {{"scene", source.text.empty() ? source.file
                                                               : fmt::format("exported, model {}",
                                                                             name(*options.model))},
                                 {"CPU seconds of the trace stage", seconds_fact(seconds)}},
                       .command = command_line(result.command)},
                      result.command};
    if (options.gap > 0.0) povray.side.facts.emplace_back("gap", fmt::format("{}", options.gap));
    for (const auto& warning : source.warnings) povray.side.facts.emplace_back("warning", warning);
    for (const auto& warning : result.warnings) povray.side.facts.emplace_back("warning", warning);
    return povray;
}

Side render_by_meniscus(const SceneComparisonOptions& options, const tracer::RenderScene& scene,
                        const tracer::Options& tracer_options) {
    std::vector<double> seconds;
    tracer::Rendered rendered;
    for (int i = 0; i < options.runs; ++i) {
        rendered = tracer::render(scene, tracer_options);
        seconds.push_back(rendered.cpu_seconds);
    }
    return {.name = "Meniscus",
            .picture = std::move(rendered.picture),
            .facts = {{"scene", options.scene.scene},
                      {"CPU seconds of the trace stage", seconds_fact(seconds)},
                      {"leaks", std::to_string(rendered.statistics.leaks)}},
            .command = own_line({"render", options.scene.scene, "--spp", "1", "-o", "meniscus.exr"},
                                options)};
}

/// Only the one pixel. Its numbers count from 1, and an end of 1 would mean the whole side.
std::string povray_pixel_line(std::vector<std::string> command, int x, int y) {
    command.insert(command.end(),
                   {fmt::format("+SC{}", x + 1), fmt::format("+EC{}", std::max(x + 1, 2)),
                    fmt::format("+SR{}", y + 1), fmt::format("+ER{}", std::max(y + 1, 2))});
    return command_line(command);
}

/// The other side as Meniscus can trace it: what POV-Ray tells no ray trees of.
struct OtherSide {
    tracer::RenderScene scene;
    std::string title;
    std::vector<std::string> words;  // of `inspect`, beside the pixel
};

/// POV-Ray's own source, if it is one that Meniscus reads, or the scene without priorities; nothing
/// where the solids are the same as on our side.
std::optional<OtherSide> make_other_side(const SceneComparisonOptions& options,
                                         const scene::Scene& scene) {
    if (options.model == povray::Model::plain)
        return OtherSide{tracer::compile(povray::without_priorities(scene)),
                         "The ray tree without priorities, as POV-Ray has it",
                         {options.scene.scene, "--model", "plain"}};
    if (options.reference.empty()) return std::nullopt;
    auto source = options.scene;
    source.scene = options.reference;
    source.declarations.emplace_back("Meniscus=1");
    try {
        return OtherSide{tracer::compile(povray::with_povrays_iors(interpret_scene(source).scene)),
                         "The ray tree of POV-Ray's source, as Meniscus reads it",
                         {options.reference, "--declare", "Meniscus=1"}};
    } catch (const lang::SourceError&) {
        return std::nullopt;
    }
}

compare::TracedSide trace(const tracer::RenderScene& scene, const tracer::Options& options,
                          const compare::WorstPixel& pixel, std::string title) {
    const inspect::Names names(scene.source);
    const auto traced = inspect::trace_pixel(scene, names, options, pixel.x, pixel.y);
    return {std::move(title), inspect::format_text(scene, names, traced),
            inspect::draw_diagram(scene, names, traced)};
}

std::vector<Explanation> explain(const SceneComparisonOptions& options,
                                 const tracer::RenderScene& scene,
                                 const std::optional<OtherSide>& other,
                                 const tracer::Options& tracer_options,
                                 const compare::Comparison& comparison,
                                 const std::vector<std::string>& povray_command) {
    std::vector<Explanation> explanations;
    for (const auto& pixel : comparison.worst) {
        const auto inspect = [&](std::vector<std::string> words) {
            words.insert(words.begin(), "inspect");
            words.insert(words.begin() + 2, {std::to_string(pixel.x), std::to_string(pixel.y)});
            return words;
        };
        auto& explanation = explanations.emplace_back(
            Explanation{.x = pixel.x, .y = pixel.y, .sides = {}, .commands = {}});
        explanation.sides.push_back(
            trace(scene, tracer_options, pixel, "The ray tree of Meniscus"));
        explanation.commands.push_back(
            {"This pixel's ray tree again:", own_line(inspect({options.scene.scene}), options)});
        if (other) {
            explanation.sides.push_back(trace(other->scene, tracer_options, pixel, other->title));
            explanation.commands.push_back(
                {other->title + ", again:", meniscus_line(inspect(other->words), options.scene)});
        }
        explanation.commands.push_back(
            {"This pixel alone by POV-Ray:", povray_pixel_line(povray_command, pixel.x, pixel.y)});
    }
    return explanations;
}

}  // namespace

SceneComparison compare_scene(const SceneComparisonOptions& given) {
    // Where both read one file, `#ifdef (Meniscus)` in it tells them apart.
    auto options = given;
    if (options.reference.empty() && !options.model)
        options.scene.declarations.emplace_back("Meniscus=1");
    auto source_scene = povray::with_povrays_iors(read_scene(options.scene).scene);
    const auto source = make_source(given, source_scene);
    for (const auto& warning : source.warnings) print_warning(warning);
    const auto other =
        options.explain ? make_other_side(given, source_scene) : std::optional<OtherSide>();
    std::string films;
    if (options.model == povray::Model::gap) {
        auto filmed = povray::with_films(std::move(source_scene), options.gap);
        source_scene = std::move(filmed.scene);
        films = film_text(filmed.thickness);
    }
    const auto scene = tracer::compile(std::move(source_scene));
    tracer::Options tracer_options;
    tracer_options.width = options.scene.width;
    tracer_options.height = options.scene.height;
    tracer_options.sampling = tracer::GridSampling{1};
    tracer_options.tree = tracer::Tree::whitted;
    tracer_options.threads = 1;  // for its time to be beside POV-Ray's of one thread

    auto povray = render_by_povray(given, source);
    auto ours = render_by_meniscus(options, scene, tracer_options);
    if (!films.empty()) ours.facts.emplace_back("films", films);
    auto regions = compare::regions_by_jumps(scene, tracer_options, ours.picture);
    auto settings = options.settings;
    settings.clip = true;  // as POV-Ray's picture is

    SceneComparison result{
        compare::compare(std::move(povray.side), std::move(ours), settings, std::move(regions)),
        {}};
    result.words.settings = {
        {"picture", fmt::format("{} x {} pixel centres, values in linear light clipped to [0, 1]",
                                options.scene.width, options.scene.height)},
        {"indices of refraction", "in single precision, as POV-Ray holds them, for both"},
        {"ray tree",
         "whitted: max_trace_level and adc_bailout of the scene, with POV-Ray's meaning"}};
    if (!source.export_command.empty())
        result.words.commands.push_back({"POV-Ray's source:", source.export_command});
    const std::vector<compare::Command> pictures = {
        {"POV-Ray's picture:", result.comparison.reference.command},
        {"Meniscus' picture:", result.comparison.picture.command}};
    result.words.commands.insert(result.words.commands.end(), pictures.begin(), pictures.end());
    if (options.explain)
        result.words.explanations =
            explain(options, scene, other, tracer_options, result.comparison, povray.command);
    return result;
}

}  // namespace meniscus::cli
