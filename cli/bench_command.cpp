#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bench/format.hpp"
#include "bench/measure.hpp"
#include "cli/bench_options.hpp"
#include "cli/command.hpp"
#include "cli/diagnostics.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/povray_source.hpp"
#include "cli/tracer_options.hpp"
#include "cli/version.hpp"
#include "compare/json_report.hpp"
#include "image/file.hpp"
#include "povray/error.hpp"

namespace meniscus::cli {
namespace {

bench::Model model_of(const std::string& text) {
    return text == "gap" ? bench::Model::gap : bench::Model::contact;
}

/// A ten-thousandth of the scene's size, as a power of ten.
double default_gap(const scene::Scene& scene) {
    return std::pow(10.0, std::floor(std::log10(tracer::compile(scene).size)) - 4.0);
}

bool has_povray() {
    try {
        povray::run_text("", {.width = 1, .height = 1});
    } catch (const povray::NotInstalled&) {
        return false;
    } catch (const povray::RunFailed&) {  // of course: there is nothing in it
    }
    return true;
}

bench::Sweep make_sweep(const BenchOptions& options, bool povray) {
    auto sweep = options.quick ? bench::quick_sweep() : bench::full_sweep();
    sweep.povray = povray;
    sweep.depth = options.depth;
    if (povray && options.models.empty()) sweep.models = {bench::Model::contact, bench::Model::gap};
    if (!options.models.empty()) sweep.models.clear();
    for (const auto& text : options.models) sweep.models.push_back(model_of(text));
    if (!options.modes.empty()) sweep.modes.clear();
    for (const auto& text : options.modes) sweep.modes.push_back(interior_mode(text));
    if (!options.samples.empty()) sweep.samples = options.samples;
    if (!options.aa.empty()) sweep.errors = options.aa;
    return sweep;
}

/// POV-Ray's own sources are told the same as the scene.
std::map<bench::Model, bench::PovRaySource> make_sources(const BenchOptions& options) {
    std::map<bench::Model, bench::PovRaySource> sources;
    for (const auto& text : options.povray_sources) {
        const auto equals = text.find('=');
        const auto model = text.substr(0, equals);
        if (equals == text.npos || (model != "contact" && model != "gap"))
            throw UsageError(
                fmt::format("--povray '{}': it must be as gap=FILE.pov or contact=FILE.pov", text));
        auto& source = sources[model_of(model)];
        source.file = text.substr(equals + 1);
        const auto told = run_options(options.scene);
        source.declares = told.declares;
        source.library_paths = told.library_paths;
    }
    return sources;
}

void print_line(const std::string& line) { fmt::print(stderr, "{}\n", line); }

/// Unless the models were asked for, those that cannot be made of the scene are left out.
void leave_out_impossible_models(const BenchOptions& options, bench::Setup& setup) {
    if (!options.models.empty()) return;
    std::erase_if(setup.sweep.models, [&](bench::Model model) {
        try {
            bench::check(setup, model);
            return false;
        } catch (const povray::ExportError& error) {
            print_line(fmt::format("left out, as POV-Ray cannot be told {} of {}: {}",
                                   bench::name(model), setup.name, error.what()));
            return true;
        }
    });
    if (setup.sweep.models.empty()) {
        setup.sweep.models = {bench::Model::contact};
        setup.sweep.povray = false;
    }
}

std::vector<std::string> outputs(const BenchOptions& options) {
    return {options.csv, options.svg, options.report, options.json};
}

bench::Setup make_setup(const BenchOptions& options, const std::string& scene, bool povray) {
    auto scene_options = options.scene;
    scene_options.scene = scene;
    scene_options.outputs = outputs(options);
    bench::Setup setup;
    setup.name = scene_options.file_name();
    setup.scene = read_scene(scene_options).scene;
    if (!options.gap_scene.empty()) {
        scene_options.scene = options.gap_scene;
        setup.gap_scene = read_scene(scene_options).scene;
    }
    setup.width = options.scene.width;
    setup.height = options.scene.height;
    setup.threads = options.threads;
    setup.runs = options.runs.value_or(options.quick ? 1 : 3);
    setup.gap = options.gap ? *options.gap : default_gap(setup.scene);
    setup.scale = options.scale;
    setup.clip = options.clip;
    setup.sweep = make_sweep(options, povray);
    setup.reference_samples =
        options.reference_samples.value_or(4 * std::ranges::max(setup.sweep.samples));
    setup.povray_sources = make_sources(options);
    setup.say = print_line;
    leave_out_impossible_models(options, setup);
    return setup;
}

void check_usage(const BenchOptions& options) {
    if (!options.svg.empty() && options.scenes.size() > 1)
        throw UsageError("--svg goes with one scene at a time; --report shows them all");
    if (!options.povray_sources.empty() && options.scenes.size() > 1)
        throw UsageError("--povray goes with one scene at a time");
    if (!options.gap_scene.empty() && options.scenes.size() > 1)
        throw UsageError("--gap-scene goes with one scene at a time");
    if (options.no_povray && !options.povray_sources.empty())
        throw UsageError("--povray and --no-povray exclude each other");
    if (options.csv == image::standard_stream && options.json == image::standard_stream)
        throw UsageError("--csv and --json cannot both go to standard output");
    std::vector<std::string> inputs = options.scenes;
    if (!options.gap_scene.empty()) inputs.push_back(options.gap_scene);
    check_outputs(outputs(options), {inputs.begin(), inputs.end()});
}

void write(const BenchOptions& options, const std::vector<bench::Report>& reports) {
    if (!options.csv.empty()) image::write_file(options.csv, bench::format_csv(reports));
    if (!options.svg.empty())
        image::write_file(options.svg, compare::draw(bench::make_plot(reports.front().result)));
    if (!options.report.empty())
        image::write_file(options.report, bench::format_page(reports, own_command_line(options)));
    if (!options.json.empty()) {
        auto list = compare::Json::array();
        for (const auto& report : reports) list.push_back(bench::to_json(report));
        image::write_file(options.json,
                          compare::dump({{"version", version}, {"benchmarks", list}}));
    }
}

ExitCode run(const BenchOptions& options) {
    check_usage(options);
    const bool povray = !options.no_povray && has_povray();
    if (!povray && !options.povray_sources.empty()) throw povray::NotInstalled();
    if (!povray && !options.no_povray)
        print_line("POV-Ray is not installed: without it (apt-get install povray)");
    const InterruptGuard interrupt;
    const bool is_quiet =
        options.csv == image::standard_stream || options.json == image::standard_stream;
    // All are read before the first is measured: what is wrong with the last costs no hours.
    std::vector<bench::Setup> setups;
    for (const auto& scene : options.scenes) {
        setups.push_back(make_setup(options, scene, povray));
        setups.back().interrupted = &interrupt.flag();
    }
    std::vector<bench::Report> reports;
    for (const auto& setup : setups) {
        auto result = bench::measure(setup);
        const bool is_interrupted = result.is_interrupted;
        reports.push_back(bench::make_report(std::move(result), options.errors));
        if (!is_quiet)
            fmt::print("{}{}", reports.size() > 1 ? "\n" : "", bench::format_text(reports.back()));
        if (is_interrupted) break;
    }
    write(options, reports);
    if (reports.back().result.is_interrupted) {
        print_error("interrupted; what was measured so far is kept");
        return ExitCode::interrupted;
    }
    return ExitCode::done;
}

}  // namespace

Command make_bench_command(CLI::App& app) {
    auto* command =
        app.add_subcommand("bench", "Run time against error of scenes, beside POV-Ray's");
    const auto options = std::make_shared<BenchOptions>();
    add_bench_options(*command, *options);
    return {command, [options] { return run(*options); }};
}

}  // namespace meniscus::cli
