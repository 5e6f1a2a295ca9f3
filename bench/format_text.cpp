#include <fmt/format.h>

#include <iterator>

#include "bench/format.hpp"
#include "bench/machine.hpp"

namespace meniscus::bench {
namespace {

std::string ratio_lines(const std::vector<Ratio>& ratios) {
    std::string text;
    for (const auto& ratio : ratios)
        fmt::format_to(std::back_inserter(text), "{:>8.3g}x  {}: {:.3f} s, {}: {:.3f} s, at {}\n",
                       ratio.value(), ratio.curve, ratio.seconds, ratio.peer, ratio.peer_seconds,
                       ratio.at);
    return text;
}

}  // namespace

Report make_report(Result result, const std::vector<double>& errors) {
    Report report{std::move(result), {}, {}};
    report.at_equal_error = ratios_at_equal_error(report.result, errors);
    report.of_equal_tasks = ratios_of_equal_tasks(report.result);
    return report;
}

std::string format_text(const Report& report) {
    const auto& result = report.result;
    auto text = fmt::format("{}, {} x {}, {} thread{}, CPU seconds of the render stage; {}\n",
                            result.scene, result.width, result.height, result.threads,
                            result.threads == 1 ? "" : "s", machine_name());
    for (const auto& [model, reference] : result.references) {
        fmt::format_to(std::back_inserter(text),
                       "reference, {}: {} samples a pixel, paths of {} segments; its own RMSE "
                       "{:.2e}, mean {:.1e}{}\n",
                       name(model), reference.samples, reference.depth, reference.rmse,
                       reference.bias,
                       model == Model::gap ? fmt::format("; gap {:g}", result.gap) : "");
    }
    if (result.is_clipped) text += "values are clipped to [0, 1], as POV-Ray's pictures are\n";
    for (const auto& curve : result.curves()) {
        fmt::format_to(std::back_inserter(text), "\n{:<58}{:>10}{:>11}{:>10}{:>12}{:>8}\n", curve,
                       "RMSE", "bias", "seconds", "segments", "ns each");
        for (const auto& row : result.rows) {
            if (row.contender.curve != curve) continue;
            const auto options =
                fmt::format("{} {}", row.is_on_front ? '*' : ' ', row.contender.options);
            if (!row.failure.empty()) {
                text += fmt::format("{:<58}{}\n", options, row.failure);
                continue;
            }
            text += fmt::format("{:<58}{:>10.2e}{:>+11.1e}{:>10.3f}", options, row.error.rmse,
                                row.error.bias, row.median_seconds());
            if (row.counts.segments > 0)
                text +=
                    fmt::format("{:>12}{:>8.1f}", row.counts.segments, row.nanoseconds_a_segment());
            text += '\n';
        }
    }
    text += "\n* on the front of its curve: none beats it in time and error\n";
    if (!report.at_equal_error.empty())
        text += "\nfaster at equal error\n" + ratio_lines(report.at_equal_error);
    if (!report.of_equal_tasks.empty())
        text += "\nfaster at the same task\n" + ratio_lines(report.of_equal_tasks);
    if (result.is_interrupted) text += "\ninterrupted: what was measured so far\n";
    return text;
}

}  // namespace meniscus::bench
