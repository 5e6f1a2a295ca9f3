#include "compare/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meniscus::compare {
namespace {

std::string figure(const std::optional<Metrics>& metrics) {
    return metrics ? fmt::format("{:.2e}", metrics->rmse) : "no picture";
}

std::string share(const std::optional<Metrics>& metrics) {
    return metrics ? fmt::format("{:.2f} %", 100.0 * metrics->share_off()) : "";
}

/// Of CSV: in quotes, those within doubled.
std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += c;
        result += c;
    }
    return result + "\"";
}

}  // namespace

std::vector<double> logarithmic_steps(double first, double last, int per_decade) {
    const double decades = std::log10(first / last);
    const int count = std::max(1, int(std::lround(std::abs(decades) * per_decade)));
    std::vector<double> steps;
    for (int i = 0; i <= count; ++i) {
        // To 12 digits, so that 1e-4 is 1e-4.
        const double exponent = std::log10(first) - decades * i / count;
        steps.push_back(std::stod(fmt::format("{:.12g}", std::pow(10.0, exponent))));
    }
    return steps;
}

std::string format_text(const Sweep& sweep) {
    auto text = fmt::format("{}\n\n{:<10}{:>26}{:>26}{:>26}{:>20}\n", sweep.title, "",
                            "POV-Ray against the film", "POV-Ray against contact",
                            "Meniscus against contact", "CPU s, POV-Ray/ours");
    text += fmt::format("{:<10}{:>13}{:>13}{:>13}{:>13}{:>13}{:>13}\n", "gap", "RMSE", "off",
                        "RMSE", "off", "RMSE", "off");
    for (const auto& row : sweep.rows) {
        text += fmt::format("{:<10.3g}{:>13}{:>13}{:>13}{:>13}{:>13}{:>13}{:>12.3f}{:>8.3f}\n",
                            row.gap, figure(row.film), share(row.film), figure(row.povray),
                            share(row.povray), figure(row.meniscus), share(row.meniscus),
                            row.povray_seconds, row.meniscus_seconds);
        if (!row.failure.empty()) text += fmt::format("{:<10}{}\n", "", row.failure);
        for (const auto& warning : row.warnings)
            text += fmt::format("{:<10}warning: {}\n", "", warning);
    }
    return text;
}

std::string format_csv(const Sweep& sweep) {
    std::string text =
        "gap,povray_film_rmse,povray_film_off,povray_contact_rmse,povray_contact_off,"
        "meniscus_contact_rmse,meniscus_contact_off,povray_cpu_seconds,meniscus_cpu_seconds,"
        "warnings\n";
    const auto pair = [](const std::optional<Metrics>& metrics) {
        return metrics ? fmt::format("{:.6g},{:.6g}", metrics->rmse, metrics->share_off()) : ",";
    };
    for (const auto& row : sweep.rows)
        text += fmt::format(
            "{:.6g},{},{},{},{:.6g},{:.6g},{}\n", row.gap, pair(row.film), pair(row.povray),
            pair(row.meniscus), row.povray_seconds, row.meniscus_seconds,
            row.warnings.empty() ? "" : quoted(fmt::format("{}", fmt::join(row.warnings, "; "))));
    return text;
}

std::string format_markdown(const Sweep& sweep) {
    std::string text =
        "| gap | POV-Ray against the film, RMSE (off) | POV-Ray against contact | Meniscus against "
        "contact |\n|---|---|---|---|\n";
    const SweepRow* warned = nullptr;
    for (const auto& row : sweep.rows) {
        if (!warned && !row.warnings.empty()) warned = &row;
        text += fmt::format("| {:g}{} | {} ({}) | {} ({}) | {} ({}) |\n", row.gap,
                            row.warnings.empty() ? "" : " \\*", figure(row.film), share(row.film),
                            figure(row.povray), share(row.povray), figure(row.meniscus),
                            share(row.meniscus));
    }
    if (warned)
        text += fmt::format("\n\\* The export warns, as of {:g}: {}\n", warned->gap,
                            fmt::join(warned->warnings, "; "));
    return text;
}

Plot make_plot(const Sweep& sweep) {
    Series film{"POV-Ray with this gap, against the exact picture of this film of air", {}};
    Series povray{"POV-Ray with this gap, against exact contact", {}};
    Series meniscus{"Meniscus with this gap, against exact contact", {}, true};
    for (const auto& row : sweep.rows) {
        if (row.gap <= 0.0) continue;
        if (row.film) film.points.push_back({row.gap, row.film->rmse});
        if (row.povray) povray.points.push_back({row.gap, row.povray->rmse});
        meniscus.points.push_back({row.gap, row.meniscus.rmse});
    }
    return {sweep.title, "gap, scene units", "RMSE, linear light", {film, povray, meniscus}};
}

}  // namespace meniscus::compare
