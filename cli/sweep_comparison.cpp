#include "cli/sweep_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/diagnostics.hpp"
#include "cli/exit_code.hpp"
#include "cli/povray_source.hpp"
#include "cli/validators.hpp"
#include "povray/export.hpp"
#include "povray/film.hpp"
#include "povray/precision.hpp"
#include "povray/run.hpp"
#include "tracer/render.hpp"

namespace meniscus::cli {
namespace {

tracer::Rendered render(const SceneOptions& options, scene::Scene scene) {
    tracer::Options tracer_options;
    tracer_options.width = options.width;
    tracer_options.height = options.height;
    tracer_options.sampling = tracer::GridSampling{1};
    tracer_options.threads = 1;
    return tracer::render(tracer::compile(std::move(scene), tracer::Hidden::left_out),
                          tracer_options);
}

/// As POV-Ray's picture is.
image::Image clipped(image::Image picture) {
    for (float& value : picture.rgb) value = std::clamp(value, 0.0f, 1.0f);
    return picture;
}

/// What both render of one width.
struct Pair {
    tracer::Rendered ours;
    std::optional<povray::Run> theirs;
    std::string failure;
    std::vector<std::string> warnings;  // of the export
};

Pair render_source(const SweepOptions& options, double gap) {
    const auto text = fmt::format("{}", gap);
    auto gapped = options.scene;
    gapped.scene = options.gapped;
    gapped.declarations.push_back("Gap=" + text);
    gapped.declarations.emplace_back("Meniscus=1");
    Pair pair{render(gapped, povray::with_povrays_iors(read_scene(gapped).scene)), {}, {}, {}};
    try {
        auto run = run_options(options.scene);
        run.declares.emplace_back("Gap", text);
        pair.theirs = povray::run(options.gapped, run);
    } catch (const povray::RunFailed& error) {
        pair.failure = error.what();
    }
    return pair;
}

/// At a gap of 0 both get solids whose faces coincide.
Pair render_export(const SweepOptions& options, const scene::Scene& scene, double gap) {
    Pair pair{render(options.scene, povray::with_films(scene, gap).scene), {}, {}, {}};
    try {
        const auto exported = povray::export_scene(scene, {.model = povray::Model::gap,
                                                           .gap = gap,
                                                           .scale = options.scale,
                                                           .source = options.scene.file_name()});
        pair.warnings = exported.warnings;
        for (const auto& warning : pair.warnings)
            print_warning(fmt::format("gap {:g}: {}", gap, warning));
        pair.theirs = povray::run_text(exported.text, {.width = options.scene.width,
                                                       .height = options.scene.height,
                                                       .declares = {},
                                                       .library_paths = {}});
    } catch (const povray::RunFailed& error) {
        pair.failure = error.what();
    }
    return pair;
}

compare::SweepRow measure_gap(const Pair& pair, double gap, double threshold,
                              const image::Image& contact) {
    const auto film = clipped(pair.ours.picture);
    compare::SweepRow row;
    row.gap = gap;
    row.meniscus = compare::measure(contact, film, threshold);
    row.meniscus_seconds = pair.ours.cpu_seconds;
    row.failure = pair.failure;
    row.warnings = pair.warnings;
    if (pair.theirs) {
        row.film = compare::measure(film, pair.theirs->picture, threshold);
        row.povray = compare::measure(contact, pair.theirs->picture, threshold);
        row.povray_seconds = pair.theirs->cpu_seconds;
    }
    return row;
}

}  // namespace

std::vector<double> parse_gaps(const std::string& text) {
    std::vector<double> numbers;
    std::string_view rest = text;
    while (true) {
        const auto colon = rest.find(':');
        const auto number = parse_number(rest.substr(0, colon));
        if (!number || *number <= 0.0) break;
        numbers.push_back(*number);
        if (colon == rest.npos) {
            if (numbers.size() == 2) return compare::logarithmic_steps(numbers[0], numbers[1], 1);
            const int per_decade = numbers.size() == 3 ? int(numbers[2]) : 0;
            if (per_decade < 1 || per_decade != numbers[2] || per_decade > 100) break;
            return compare::logarithmic_steps(numbers[0], numbers[1], per_decade);
        }
        rest.remove_prefix(colon + 1);
    }
    throw UsageError(
        fmt::format("--sweep-gap '{}': it must be as 1e-1:1e-9, or 1e-1:1e-9:2 for two "
                    "steps a decade",
                    text));
}

compare::Sweep sweep_gaps(const SweepOptions& options) {
    const auto scene = povray::with_povrays_iors(read_scene(options.scene).scene);
    const auto contact = clipped(render(options.scene, scene).picture);
    compare::Sweep sweep{
        fmt::format("{} with a gap, {} x {} pixel centres", options.scene.file_name(),
                    options.scene.width, options.scene.height),
        {}};
    auto gaps = options.gaps;
    gaps.push_back(0.0);
    for (const double gap : gaps) {
        fmt::print(stderr, "gap {:g}\n", gap);
        const auto pair = options.gapped.empty() ? render_export(options, scene, gap)
                                                 : render_source(options, gap);
        sweep.rows.push_back(measure_gap(pair, gap, options.threshold, contact));
    }
    if (std::ranges::none_of(sweep.rows, [](const auto& row) { return row.povray.has_value(); }))
        throw povray::RunFailed(sweep.rows.front().failure);
    return sweep;
}

}  // namespace meniscus::cli
