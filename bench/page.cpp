#include "compare/page.hpp"

#include <fmt/format.h>

#include "bench/format.hpp"
#include "bench/machine.hpp"
#include "compare/markup.hpp"

namespace meniscus::bench {
namespace {

using compare::escape;
using compare::Table;

std::string ratio_table(const std::string& caption, const std::vector<Ratio>& ratios) {
    if (ratios.empty()) return {};
    Table table{caption, {"", "seconds", "against", "seconds", "at", "times faster"}, {}};
    for (const auto& ratio : ratios)
        table.rows.push_back({escape(ratio.curve), fmt::format("{:.4g}", ratio.seconds),
                              escape(ratio.peer), fmt::format("{:.4g}", ratio.peer_seconds),
                              escape(ratio.at), fmt::format("{:.3g}", ratio.value())});
    return compare::format_table(table);
}

std::string reference_table(const Result& result) {
    Table table{"What errors are measured against; the errors are its own, from two halves.",
                {"reference", "samples a pixel", "segments of a path", "RMSE", "mean"},
                {}};
    for (const auto& [model, reference] : result.references)
        table.rows.push_back(
            {model == Model::gap ? fmt::format("gap of {:g}", result.gap) : name(model),
             std::to_string(reference.samples), std::to_string(reference.depth),
             fmt::format("{:.2e}", reference.rmse), fmt::format("{:.1e}", reference.bias)});
    return compare::format_table(table);
}

std::vector<std::string> cells(const Row& row) {
    std::vector<std::string> cells = {
        fmt::format("{}{}", row.is_on_front ? "★ " : "", escape(row.contender.options))};
    if (!row.failure.empty()) {
        cells.push_back(escape(row.failure));
        return cells;
    }
    for (const auto& text :
         {fmt::format("{:.3e}", row.error.rmse), fmt::format("{:+.1e}", row.error.bias),
          fmt::format("{:.4g}", row.median_seconds()), std::to_string(row.seconds.size())})
        cells.push_back(text);
    if (row.contender.is_povray()) return cells;
    const auto& n = row.counts;
    for (const auto count :
         {n.camera_rays, n.reflected_rays, n.refracted_rays, n.shadow_rays, n.segments})
        cells.push_back(std::to_string(count));
    cells.push_back(fmt::format("{:.1f}", row.nanoseconds_a_segment()));
    return cells;
}

std::string curve_table(const Result& result, const std::string& curve) {
    Table table{escape(curve) + ". ★: no other of this curve is faster and nearer.",
                {"options", "RMSE", "bias", "seconds", "runs"},
                {}};
    bool has_counts = false;
    for (const auto& row : result.rows) {
        if (row.contender.curve != curve) continue;
        has_counts = has_counts || !row.contender.is_povray();
        table.rows.push_back(cells(row));
    }
    if (has_counts)
        for (const auto* head :
             {"camera", "reflected", "refracted", "shadow", "segments", "ns a segment"})
            table.head.emplace_back(head);
    return compare::format_table(table);
}

std::string section(const Report& report) {
    const auto& result = report.result;
    auto out = fmt::format(
        "<h2>{}</h2>\n<p>{} x {}, {} thread{}. Seconds are CPU seconds of the render stage, the "
        "median of interleaved runs.{}{}</p>\n",
        escape(result.scene), result.width, result.height, result.threads,
        result.threads == 1 ? "" : "s",
        result.is_clipped ? " Values are clipped to [0, 1], as POV-Ray's pictures are." : "",
        result.is_interrupted ? " <strong class=\"bad\">Interrupted: what was measured so "
                                "far.</strong>"
                              : "");
    out += ratio_table("At equal error, read off the fronts.", report.at_equal_error);
    out += ratio_table("At the same task.", report.of_equal_tasks);
    out += "<figure>\n" + compare::draw(make_plot(result)) + "</figure>\n";
    out += reference_table(result);
    for (const auto& curve : result.curves()) out += curve_table(result, curve);
    return out;
}

}  // namespace

compare::Plot make_plot(const Result& result) {
    compare::Plot plot{fmt::format("{}: run time against error", result.scene),
                       "CPU seconds",
                       "RMSE, linear light",
                       {}};
    for (const auto& curve : result.curves()) {
        compare::Series points{curve, {}};
        for (const auto& row : result.rows)
            if (row.contender.curve == curve && row.failure.empty())
                points.points.push_back({row.median_seconds(), row.error.rmse});
        points.line.emplace();
        for (const auto& reach : result.front(curve))
            points.line->push_back({reach.seconds, reach.error});
        plot.series.push_back(std::move(points));
    }
    return plot;
}

std::string format_page(const std::vector<Report>& reports, const std::string& command) {
    const std::string title = "Run time against error";
    auto body = fmt::format("<h1>{}</h1>\n<p>{}</p>\n<pre class=\"command\">{}</pre>\n", title,
                            escape(machine_name()), escape(command));
    for (const auto& report : reports) body += section(report);
    return compare::format_page(
        {.title = title, .style = "figure { margin: 1rem 0; }\n", .body = body, .script = {}});
}

}  // namespace meniscus::bench
