#include "bench/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meniscus::bench {
namespace {

using tracer::InteriorMode;
using Words = std::vector<std::string>;

std::string describe(const Limits& limits) {
    return fmt::format("max_trace_level {}, adc_bailout {:.4g}", limits.max_trace_level,
                       limits.adc_bailout);
}

std::string curve_name(Model model, const tracer::Options& options) {
    auto text = fmt::format("Meniscus, {}", name(model));
    if (options.interior != InteriorMode::sweep)
        text += fmt::format(", {}", tracer::name(options.interior));
    else if (options.kernel == tracer::Kernel::general)
        text += ", general";
    return text;
}

Contender by_meniscus(Model model, const tracer::Options& options, const std::string& words) {
    Contender contender{curve_name(model, options), words, {}, model, {}, {}};
    contender.how = ByMeniscus{options};
    return contender;
}

/// As low-discrepancy sets of growing size, which is what all modes can do alike.
void add_samples(std::vector<Contender>& all, const Sweep& sweep, Model model,
                 tracer::Options options) {
    for (const int count : sweep.samples) {
        options.sampling = tracer::CountSampling{count};
        auto contender = by_meniscus(model, options, fmt::format("--spp {}", count));
        contender.task = fmt::format("{}, --spp {}", name(model), count);
        all.push_back(std::move(contender));
    }
}

void add_whitted(std::vector<Contender>& all, const Sweep& sweep, Model model,
                 tracer::Options options) {
    options.sampling = tracer::GridSampling{1};
    options.tree = tracer::Tree::whitted;
    for (const auto& limits : sweep.limits) {
        auto contender = by_meniscus(model, options, fmt::format("--spp 1, {}", describe(limits)));
        contender.limits = limits;
        contender.task = fmt::format("{}, pixel centres, {}", name(model), describe(limits));
        all.push_back(std::move(contender));
    }
}

void add_errors(std::vector<Contender>& all, const Sweep& sweep, Model model,
                tracer::Options options) {
    for (const double error : sweep.errors) {
        options.sampling = tracer::ErrorSampling{error};
        all.push_back(by_meniscus(model, options, fmt::format("--aa {:g}", error)));
    }
}

void add_full_trees(std::vector<Contender>& all, const Sweep& sweep, Model model,
                    tracer::Options options) {
    options.sampling = tracer::CountSampling{sweep.full_samples};
    options.tree = tracer::Tree::full;
    for (const int depth : sweep.depths) {
        for (const double cutoff : sweep.cutoffs) {
            options.depth = depth;
            options.cutoff = cutoff;
            all.push_back(by_meniscus(model, options,
                                      fmt::format("--spp {} --tree full --depth {} --cutoff {:.4g}",
                                                  sweep.full_samples, depth, cutoff)));
        }
    }
}

void add_povray(std::vector<Contender>& all, const Sweep& sweep, Model model) {
    for (const auto& limits : sweep.limits) {
        for (const auto& antialiasing : sweep.antialiasings) {
            Contender contender{
                fmt::format("POV-Ray, {}", name(model)),
                fmt::format("{}, {}", fmt::join(antialiasing, " "), describe(limits)),
                {},
                model,
                limits,
                ByPovRay{antialiasing}};
            if (antialiasing == Words{"-A"})
                contender.task =
                    fmt::format("{}, pixel centres, {}", name(model), describe(limits));
            all.push_back(std::move(contender));
        }
    }
}

/// Adaptive by contrast, and the same number of samples in all pixels (a threshold of 0).
Words method(int number, double threshold, int depth) {
    return {fmt::format("+A{:.2f}", threshold), fmt::format("+AM{}", number),
            fmt::format("+R{}", depth), "-J"};
}

}  // namespace

Sweep quick_sweep() {
    Sweep sweep;
    sweep.samples = {2, 4, 8, 16};
    sweep.errors = {0.03, 0.015};
    sweep.cutoffs = {1.0 / 255.0, 1e-3};
    sweep.depths = {20};
    sweep.limits = {{20, 1.0 / 255.0}, {20, 1e-3}};
    sweep.antialiasings = {
        {"-A"}, method(1, 0.1, 3), method(2, 0.1, 2), method(1, 0.0, 3), method(1, 0.0, 5)};
    return sweep;
}

Sweep full_sweep() {
    Sweep sweep;
    sweep.modes = {InteriorMode::sweep, InteriorMode::recast, InteriorMode::off};
    sweep.samples = {2, 4, 8, 16, 32, 64};
    sweep.errors = {0.05, 0.03, 0.02, 0.014, 0.01, 0.007, 0.005};
    sweep.cutoffs = {1.0 / 255.0, 1e-3, 1e-4};
    sweep.depths = {20, 40, 100};
    for (const int levels : {20, 40})
        for (const double bailout : {1.0 / 255.0, 2e-3, 1e-3, 3e-4, 1e-4})
            sweep.limits.push_back({levels, bailout});
    sweep.antialiasings = {{"-A"},
                           method(1, 0.3, 3),
                           method(1, 0.1, 3),
                           method(1, 0.03, 3),
                           method(1, 0.0, 2),
                           method(1, 0.0, 3),
                           method(1, 0.0, 4),
                           method(2, 0.1, 2),
                           method(2, 0.05, 3),
                           method(2, 0.01, 4)};
    return sweep;
}

std::vector<Contender> make_contenders(const Sweep& sweep) {
    std::vector<Contender> all;
    const auto is_other = [](InteriorMode mode) { return mode != InteriorMode::sweep; };
    const bool has_others = std::ranges::any_of(sweep.modes, is_other);
    for (const auto model : sweep.models) {
        for (const auto mode : sweep.modes) {
            tracer::Options options;
            options.interior = mode;
            options.depth = sweep.depth;
            add_whitted(all, sweep, model, options);
            add_samples(all, sweep, model, options);
            if (is_other(mode)) continue;
            add_errors(all, sweep, model, options);
            add_full_trees(all, sweep, model, options);
            if (!has_others) continue;
            // The other modes know no lanes: beside them stands `sweep` without lanes.
            options.kernel = tracer::Kernel::general;
            add_whitted(all, sweep, model, options);
            add_samples(all, sweep, model, options);
        }
        if (sweep.povray) add_povray(all, sweep, model);
    }
    return all;
}

}  // namespace meniscus::bench
