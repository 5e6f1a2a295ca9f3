#include "cli/tracer_options.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "cli/exit_code.hpp"
#include "cli/validators.hpp"
#include "lanes/kernel.hpp"

namespace meniscus::cli {
namespace {

constexpr auto trees =
    std::to_array({tracer::Tree::whitted, tracer::Tree::full, tracer::Tree::sampled});
constexpr auto modes = std::to_array(
    {tracer::InteriorMode::sweep, tracer::InteriorMode::recast, tracer::InteriorMode::off});

constexpr auto filters =
    std::to_array({tracer::PixelFilter::box, tracer::PixelFilter::blackman_harris,
                   tracer::PixelFilter::mitchell});

std::vector<std::string> names(const auto& values) {
    std::vector<std::string> result;
    for (const auto value : values) result.emplace_back(tracer::name(value));
    return result;
}

auto named(const auto& values, std::string_view text) {
    for (const auto value : values)
        if (tracer::name(value) == text) return value;
    throw UsageError(fmt::format("'{}' is not one of {}", text, fmt::join(names(values), ", ")));
}

tracer::Sampling make_sampling(const TracerOptions& options) {
    if (options.grid) return tracer::GridSampling{*options.grid};
    if (options.samples == 1) return tracer::GridSampling{1};
    if (options.samples) return tracer::CountSampling{*options.samples};
    if (options.seconds) return tracer::TimeSampling{*options.seconds};
    if (options.contrast)
        return tracer::ContrastSampling{*options.contrast, options.contrast_depth,
                                        options.contrast_method};
    if (options.error) return tracer::ErrorSampling{*options.error};
    return tracer::ErrorSampling{};
}

/// POV-Ray counts from 1 and includes the end; up to 1 (an end) or below 1 (a start) it means a
/// share of the side.
int pov_start(std::optional<double> start, int side) {
    if (!start) return 0;
    return int(*start < 1.0 ? std::floor(*start * side) : *start - 1.0);
}
int pov_end(std::optional<double> end, int side) {
    if (!end) return side;
    return int(*end <= 1.0 ? std::floor(*end * side) : *end);
}

std::optional<tracer::Region> make_region(const TracerOptions& options, int width, int height) {
    tracer::Region region{0, 0, width, height};
    const bool as_pov_ray =
        options.start_column || options.start_row || options.end_column || options.end_row;
    if (as_pov_ray)
        region = {pov_start(options.start_column, width), pov_start(options.start_row, height),
                  pov_end(options.end_column, width), pov_end(options.end_row, height)};
    else if (!options.region.empty())
        region = {options.region[0], options.region[1], options.region[2], options.region[3]};
    else
        return std::nullopt;
    if (region.x0 < 0 || region.y0 < 0 || region.x1 > width || region.y1 > height)
        throw UsageError(fmt::format("the region {} {} {} {} does not lie in a picture of {} x {}",
                                     region.x0, region.y0, region.x1, region.y1, width, height));
    if (region.x0 >= region.x1 || region.y0 >= region.y1)
        throw UsageError(fmt::format("the region {} {} {} {} is empty", region.x0, region.y0,
                                     region.x1, region.y1));
    return region;
}

std::string describe(const tracer::GridSampling& s) { return fmt::format("--grid {}", s.k); }
std::string describe(const tracer::CountSampling& s) { return fmt::format("--spp {}", s.samples); }
std::string describe(const tracer::ErrorSampling& s) { return fmt::format("--aa {}", s.error); }
std::string describe(const tracer::TimeSampling& s) { return fmt::format("--time {}", s.seconds); }
std::string describe(const tracer::ContrastSampling& s) {
    return fmt::format("--contrast {} --contrast-depth {} --contrast-method {}", s.threshold,
                       s.depth, s.method);
}

}  // namespace

tracer::InteriorMode interior_mode(std::string_view name) { return named(modes, name); }

void add_tracer_options(CLI::App& app, TracerOptions& o) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;

    app.add_option("--region", o.region,
                   "Only the pixels x0 <= x < x1, y0 <= y < y1, from the top left")
        ->type_name("X0 Y0 X1 Y1")
        ->expected(4)
        ->group("Picture");

    const std::vector<CLI::Option*> samplings = {
        app.add_option("--spp", o.samples,
                       "Samples a pixel: a low-discrepancy set; 1 is the pixel centre")
            ->check(CLI::Range(1, 1 << 24))
            ->type_name("N"),
        app.add_option("--grid", o.grid, "The K x K midpoints of a pixel")
            ->check(CLI::Range(1, 1 << 12))
            ->type_name("K"),
        app.add_option("--aa", o.error, "Adaptive, to this root mean square error; default 0.01")
            ->check(positive())
            ->type_name("ERROR"),
        app.add_option("--time", o.seconds, "As many samples as S seconds allow")
            ->check(positive())
            ->type_name("S"),
        app.add_option("--contrast", o.contrast,
                       "POV-Ray's +A: more samples where neighbours differ by this")
            ->check(not_negative())
            ->type_name("THRESHOLD")};
    for (auto* sampling : samplings) {
        sampling->group("Sampling, one of")->multi_option_policy(last);
        for (auto* other : samplings)
            if (other != sampling) sampling->excludes(other);
    }
    app.add_option("--contrast-depth", o.contrast_depth, "POV-Ray's +R")
        ->check(CLI::Range(1, 9))
        ->multi_option_policy(last)
        ->type_name("N")
        ->group("Sampling");
    app.add_option("--contrast-method", o.contrast_method, "POV-Ray's +AM: 1 or 2")
        ->check(CLI::Range(1, 2))
        ->multi_option_policy(last)
        ->type_name("N")
        ->group("Sampling");
    app.add_option("--filter", o.filter,
                   "What a pixel is the mean of: box (its square), blackman-harris (radius 1.5 "
                   "pixels) or mitchell (radius 2, sharper)")
        ->check(CLI::IsMember(names(filters)))
        ->excludes("--grid")
        ->excludes("--contrast")
        ->type_name("FILTER")
        ->group("Sampling");
    app.add_option("--seed", o.seed, "Another set of samples")->type_name("N")->group("Sampling");

    app.add_option("--tree", o.tree,
                   "Branches of the ray tree: whitted (POV-Ray's way; implied by --spp 1, --grid, "
                   "--contrast), "
                   "full (every branch) or sampled (unbiased; implied by the others)")
        ->check(CLI::IsMember(names(trees)))
        ->type_name("TREE")
        ->group("Light");
    app.add_option("--interior", o.interior,
                   "How a ray knows where it is: sweep, recast (the paper's way) or off")
        ->check(CLI::IsMember(names(modes)))
        ->type_name("MODE")
        ->group("Light");
    auto kernels = lanes::instruction_sets();
    kernels.insert(kernels.begin(), {"automatic", "general"});
    app.add_option(
           "--kernel", o.kernel,
           "Code that follows rays: automatic (in lanes where the scene allows it), general "
           "(one at a time), or lanes of this instruction set")
        ->check(CLI::IsMember(kernels))
        ->type_name("KERNEL")
        ->group("Light");
    app.add_option("--cutoff", o.cutoff, "--tree full: branches of lower weight are dropped")
        ->check(not_negative())
        ->type_name("WEIGHT")
        ->group("Light");
    app.add_option(
           "--depth", o.depth,
           "--tree full or sampled: segments of a path; without --tree: bits of a PNG, 8 or 16")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("N")
        ->group("Light");
    app.add_option("--threads", o.threads, "Default: all cores")
        ->check(CLI::Range(0, 4096))
        ->multi_option_policy(last)
        ->type_name("N");

    const struct {
        const char* name;
        std::optional<double>& value;
    } edges[] = {{"--start-column", o.start_column},
                 {"--start-row", o.start_row},
                 {"--end-column", o.end_column},
                 {"--end-row", o.end_row}};
    for (const auto& edge : edges)
        app.add_option(edge.name, edge.value,
                       "As POV-Ray counts: from 1, end included, or a share of the side")
            ->check(not_negative())
            ->multi_option_policy(last)
            ->type_name("N")
            ->excludes("--region")
            ->group("POV-Ray's region (+SC +SR +EC +ER)");
}

tracer::Options make_tracer_options(const TracerOptions& options, const SceneOptions& scene) {
    tracer::Options result;
    result.width = scene.width;
    result.height = scene.height;
    result.region = make_region(options, scene.width, scene.height);
    result.sampling = make_sampling(options);
    if (!options.tree.empty()) result.tree = named(trees, options.tree);
    result.interior = interior_mode(options.interior);
    if (options.kernel == "general") {
        result.kernel = tracer::Kernel::general;
    } else if (options.kernel != "automatic") {
        result.instruction_set = options.kernel;
    }
    if (options.depth) result.depth = *options.depth;
    if (options.cutoff) {
        if (result.tree != tracer::Tree::full)
            throw UsageError("--cutoff drops branches of --tree full; the other trees have none");
        result.cutoff = *options.cutoff;
    }
    result.filter = named(filters, options.filter);
    result.seed = options.seed;
    result.threads = options.threads;
    return result;
}

std::string canonical_options(const tracer::Options& options) {
    const tracer::Options defaults;
    const auto tree = tracer::implied_tree(options);
    auto text = fmt::format("--width {} --height {}", options.width, options.height);
    if (const auto& r = options.region)
        text += fmt::format(" --region {} {} {} {}", r->x0, r->y0, r->x1, r->y1);
    text += ' ' + std::visit([](const auto& s) { return describe(s); }, options.sampling);
    if (options.filter != defaults.filter)
        text += fmt::format(" --filter {}", name(options.filter));
    text += fmt::format(" --tree {} --interior {}", name(tree), name(options.interior));
    if (tree != tracer::Tree::whitted && options.depth != defaults.depth)
        text += fmt::format(" --depth {}", options.depth);
    if (tree == tracer::Tree::full && options.cutoff != defaults.cutoff)
        text += fmt::format(" --cutoff {}", options.cutoff);
    if (options.seed != defaults.seed) text += fmt::format(" --seed {}", options.seed);
    return text;
}

}  // namespace meniscus::cli
