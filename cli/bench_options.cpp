#include "cli/bench_options.hpp"

#include <fmt/format.h>

#include "cli/shell_words.hpp"
#include "cli/validators.hpp"

namespace meniscus::cli {
namespace {

std::string joined(const auto& values) { return fmt::format("{}", fmt::join(values, ",")); }

}  // namespace

void add_bench_options(CLI::App& command, BenchOptions& o) {
    command.add_option("SCENE", o.scenes, "The scene files")->required()->type_name("");
    add_scene_settings(command, o.scene);
    const auto list = [&](const char* name, auto& values, const char* what, const char* type) {
        return command.add_option(name, values, what)
            ->delimiter(',')
            ->allow_extra_args(false)
            ->type_name(type);
    };
    command.add_flag("--quick", o.quick, "Fewer settings, one run of each: minutes, not hours");
    command.add_option("--runs", o.runs, "Times are the median of N runs; default 3, quick 1")
        ->check(CLI::Range(1, 1000))
        ->type_name("N");
    command.add_option("--threads", o.threads, "Of both renderers")
        ->check(CLI::Range(1, 4096))
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option("--reference-spp", o.reference_samples,
                    "Samples a pixel of each half of the reference; default: 4 times the most "
                    "that are measured")
        ->check(CLI::Range(2, 1 << 24))
        ->type_name("N");
    list("--errors", o.errors, "Where fronts are compared; default: three errors for each pair",
         "LIST")
        ->check(positive());

    const auto sweep = "What is tried";
    list("--models", o.models,
         "contact, gap (films of the outside's medium between solids); default: contact, with "
         "POV-Ray both",
         "LIST")
        ->check(CLI::IsMember({"contact", "gap"}))
        ->group(sweep);
    list("--modes", o.modes, "Of --interior: sweep, recast, off; default: all, quick sweep", "LIST")
        ->check(CLI::IsMember({"sweep", "recast", "off"}))
        ->group(sweep);
    list("--spp", o.samples, "Samples a pixel", "LIST")
        ->check(CLI::Range(2, 1 << 24))
        ->group(sweep);
    list("--aa", o.aa, "Errors to sample to", "LIST")->check(positive())->group(sweep);
    command.add_option("--depth", o.depth, "Segments of a path, in references too")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("N")
        ->capture_default_str()
        ->group(sweep);
    command
        .add_option("--gap", o.gap,
                    "The gap model's films, in scene units; default: about 1e-4 of the scene")
        ->check(positive())
        ->type_name("G")
        ->group(sweep);
    command
        .add_option("--gap-scene", o.gap_scene,
                    "The gap model as a scene of its own, in place of SCENE with films around its "
                    "solids; declare its gap as --declare")
        ->type_name("FILE.scene")
        ->group(sweep);
    command.add_flag("--clip", o.clip, "Clip values to [0, 1]; implied by POV-Ray")->group(sweep);

    const auto povray = "POV-Ray";
    command.add_flag("--no-povray", o.no_povray, "Without it")->group(povray);
    list("--povray", o.povray_sources,
         "A source of its own in place of a model's export; it takes max_trace_level and "
         "adc_bailout from MTL and ADC, which are declared, as --declare's names are",
         "MODEL=FILE.pov")
        ->group(povray);
    command
        .add_option("--scale", o.scale,
                    "Units of the export in one of the scene; default: by the scene's size")
        ->check(positive())
        ->type_name("S")
        ->group(povray);

    const auto output = "Output";
    command.add_option("--csv", o.csv, "All points; - is standard output")
        ->type_name("FILE|-")
        ->group(output);
    command.add_option("--svg", o.svg, "The plot")->type_name("FILE")->group(output);
    command
        .add_option("--report", o.report,
                    "Write an HTML page that shows it all and needs no network")
        ->type_name("OUT.html")
        ->group(output);
    command.add_option("--json", o.json, "All numbers; - is standard output")
        ->type_name("FILE|-")
        ->group(output);
}

std::string own_command_line(const BenchOptions& o) {
    std::vector<std::string> words = {"meniscus", "bench"};
    const auto add = [&](const char* name, const auto& value) {
        words.insert(words.end(), {name, fmt::format("{}", value)});
    };
    words.insert(words.end(), o.scenes.begin(), o.scenes.end());
    add("-W", o.scene.width);
    add("-H", o.scene.height);
    for (const auto& declaration : o.scene.declarations) add("--declare", declaration);
    for (const auto& path : o.scene.library_paths) add("-L", path);
    if (o.quick) words.emplace_back("--quick");
    if (o.no_povray) words.emplace_back("--no-povray");
    if (o.clip) words.emplace_back("--clip");
    if (!o.models.empty()) add("--models", joined(o.models));
    if (!o.modes.empty()) add("--modes", joined(o.modes));
    if (!o.samples.empty()) add("--spp", joined(o.samples));
    if (!o.aa.empty()) add("--aa", joined(o.aa));
    if (!o.errors.empty()) add("--errors", joined(o.errors));
    if (o.runs) add("--runs", *o.runs);
    if (o.reference_samples) add("--reference-spp", *o.reference_samples);
    if (o.gap) add("--gap", *o.gap);
    if (!o.gap_scene.empty()) add("--gap-scene", o.gap_scene);
    if (o.scale) add("--scale", *o.scale);
    for (const auto& source : o.povray_sources) add("--povray", source);
    add("--depth", o.depth);
    add("--threads", o.threads);
    if (!o.report.empty()) add("--report", o.report);
    return command_line(words);
}

}  // namespace meniscus::cli
