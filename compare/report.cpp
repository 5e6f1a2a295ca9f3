#include "compare/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/difference_picture.hpp"
#include "compare/histogram.hpp"
#include "compare/json_report.hpp"
#include "compare/markup.hpp"
#include "compare/page.hpp"
#include "compare/page_files.hpp"
#include "compare/pixel_data.hpp"
#include "compare/plot.hpp"
#include "image/png.hpp"

namespace meniscus::compare {
namespace {

using image::Image;

std::string still(const std::string& name, const Image& picture) {
    Image whole = picture;
    whole.x0 = whole.y0 = 0;
    whole.full_width = whole.width;
    whole.full_height = whole.height;
    return fmt::format(
        "<figure><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\">"
        "<figcaption>{}</figcaption></figure>\n",
        data_uri("image/png", image::encode_png(whole, {}, {})), escape(name), whole.width,
        whole.height, escape(name));
}

std::string verdict(const Comparison& comparison, const std::optional<double>& tolerance) {
    const auto rmse = comparison.all.rmse;
    if (!tolerance)
        return fmt::format("<p>RMSE {:.3g}, largest difference {:.3g}.</p>\n", rmse,
                           comparison.all.largest);
    const bool good = rmse <= *tolerance && comparison.all.not_finite == 0;
    return fmt::format("<p class=\"{}\"><strong>{}</strong>: RMSE {:.3g}, tolerance {:.3g}.</p>\n",
                       good ? "good" : "bad", good ? "Within the tolerance" : "Above the tolerance",
                       rmse, *tolerance);
}

std::vector<std::string> row(const std::string& name, const Metrics& m) {
    std::vector<std::string> cells = {escape(name),
                                      std::to_string(m.pixels),
                                      fmt::format("{:.3g}", m.rmse),
                                      fmt::format("{:.3g}", m.largest),
                                      fmt::format("{:+.3g}", m.bias),
                                      fmt::format("{:.3f} %", 100.0 * m.share_off()),
                                      std::to_string(m.off)};
    if (m.not_finite > 0) cells.back() += fmt::format(" ({} not finite)", m.not_finite);
    return cells;
}

std::string numbers(const Comparison& comparison) {
    Table table{
        "Linear light, over red, green and blue. Regions: " + escape(comparison.regions.how) + ".",
        {"", "pixels", "RMSE", "largest", "bias",
         fmt::format("off by more than {:g}", comparison.settings.threshold), "of them"},
        {row("all", comparison.all)}};
    table.head.back() = "pixels off";
    for (std::size_t i = 0; i < comparison.by_region.size(); ++i)
        table.rows.push_back(row(comparison.regions.parts[i].name, comparison.by_region[i]));
    return format_table(table);
}

std::string settings(const Comparison& comparison, const ReportWords& words) {
    Table table{"", {"what", "value"}, {}};
    for (const auto& [name, value] : words.settings)
        table.rows.push_back({escape(name), escape(value)});
    for (const auto* side : {&comparison.reference, &comparison.picture})
        for (const auto& [name, value] : side->facts)
            table.rows.push_back({escape(side->name) + ": " + escape(name), escape(value)});
    return "<div class=\"prose\">" + format_table(table) + "</div>\n";
}

std::string commands(const std::vector<Command>& list) {
    std::string out;
    for (const auto& command : list)
        out += fmt::format("<p>{}</p>\n<pre class=\"command\">{}</pre>\n", escape(command.purpose),
                           escape(command.line));
    return out;
}

std::string drawn_histogram(const Comparison& comparison) {
    const auto data = histogram(comparison.errors);
    Bars bars{"How many pixels are how far off",
              "largest difference of a pixel's channels",
              "pixels",
              {}};
    bars.bars.push_back({"<1e-7", "below 1e-7", double(data.below)});
    for (std::size_t i = 0; i < data.counts.size(); ++i) {
        const auto label = i > 0 && i % Histogram::bins_per_decade == 0
                               ? fmt::format("1e{}", -7 + int(i) / Histogram::bins_per_decade)
                               : std::string();
        bars.bars.push_back({label,
                             fmt::format("{:.2g} to {:.2g}", Histogram::lower_bound(i),
                                         Histogram::lower_bound(i + 1)),
                             double(data.counts[i])});
    }
    bars.bars.push_back({"≥1", "1 and more, or not finite", double(data.above)});
    return draw(bars);
}

std::string color_of(const Image& picture, int column, int row) {
    const float* rgb = picture.pixel(column, row);
    return fmt::format("{:.5f}<br>{:.5f}<br>{:.5f}", rgb[0], rgb[1], rgb[2]);
}

/// The colours of a pixel and its eight neighbours.
std::string neighbourhood(const Side& side, int x, int y) {
    Table table{
        fmt::format("{}: linear red, green and blue around ({}, {})", escape(side.name), x, y),
        {"row"},
        {}};
    const Image& p = side.picture;
    for (int u = x - 1; u <= x + 1; ++u) table.head.push_back(fmt::format("column {}", u));
    for (int v = y - 1; v <= y + 1; ++v) {
        std::vector<std::string> cells = {std::to_string(v)};
        for (int u = x - 1; u <= x + 1; ++u) {
            const int column = u - p.x0, line = v - p.y0;
            const bool is_there = column >= 0 && line >= 0 && column < p.width && line < p.height;
            cells.push_back(is_there ? color_of(p, column, line) : "");
        }
        table.rows.push_back(std::move(cells));
    }
    return format_table(table);
}

const Explanation* find_explanation(const ReportWords& words, const WorstPixel& pixel) {
    const auto found = std::ranges::find_if(words.explanations, [&](const Explanation& known) {
        return known.x == pixel.x && known.y == pixel.y;
    });
    return found == words.explanations.end() ? nullptr : &*found;
}

std::string worst_table(const Comparison& comparison, const ReportWords& words) {
    Table table{"The worst pixels, no two of them neighbours.",
                {"pixel", "off by", comparison.reference.name, comparison.picture.name, ""},
                {}};
    for (auto& cell : table.head) cell = escape(cell);
    for (const auto& pixel : comparison.worst) {
        const auto color = [&](const Side& side) {
            const float* c =
                side.picture.pixel(pixel.x - side.picture.x0, pixel.y - side.picture.y0);
            return fmt::format("{:.5f}, {:.5f}, {:.5f}", c[0], c[1], c[2]);
        };
        const auto link = fmt::format(
            "<a href=\"#pixel-{0}-{1}\">{2}</a>", pixel.x, pixel.y,
            find_explanation(words, pixel) ? "why: ray tree and neighbours" : "neighbours");
        table.rows.push_back(
            {fmt::format("<button type=\"button\" class=\"go\" data-x=\"{0}\" data-y=\"{1}\">({0}, "
                         "{1})</button>",
                         pixel.x, pixel.y),
             fmt::format("{:.3g}", pixel.error), color(comparison.reference),
             color(comparison.picture), link});
    }
    return comparison.worst.empty() ? "<p>None: the pictures are equal.</p>\n"
                                    : format_table(table);
}

std::string worst_details(const Comparison& comparison, const ReportWords& words) {
    std::string out;
    for (const auto& pixel : comparison.worst) {
        out += fmt::format(
            "<details id=\"pixel-{0}-{1}\"><summary>Pixel ({0}, {1}), off by {2:.3g}</summary>\n",
            pixel.x, pixel.y, pixel.error);
        out += "<div class=\"pair\">" + neighbourhood(comparison.reference, pixel.x, pixel.y) +
               neighbourhood(comparison.picture, pixel.x, pixel.y) + "</div>\n";
        if (const auto* known = find_explanation(words, pixel)) {
            out += commands(known->commands);
            for (const auto& side : known->sides) {
                out += fmt::format("<h3>{}</h3>\n<pre tabindex=\"0\">{}</pre>\n",
                                   escape(side.title), escape(side.trace));
                out += fmt::format(
                    "<img class=\"diagram\" alt=\"{}, seen from the side\" src=\"{}\">\n",
                    escape(side.title), data_uri("image/svg+xml", side.diagram));
            }
        }
        out += "</details>\n";
    }
    return out;
}

/// What the script needs; "</" would end the element that holds it.
std::string data_for_script(const Comparison& comparison, double scale) {
    const Json json{{"width", comparison.width()},
                    {"height", comparison.height()},
                    {"x0", comparison.x0()},
                    {"y0", comparison.y0()},
                    {"reference", comparison.reference.name},
                    {"picture", comparison.picture.name},
                    {"scale", scale}};
    auto text = dump(json);
    for (std::size_t at = 0; (at = text.find("</", at)) != text.npos;) text.insert(at + 1, "\\");
    return text;
}

}  // namespace

std::string format_report(const Comparison& comparison, const ReportWords& words) {
    const double scale = suggested_scale(comparison);
    const auto& reference = comparison.reference;
    const auto& picture = comparison.picture;
    const auto body =
        fill(page_files::comparison_html,
             {{"title", escape(words.title)},
              {"verdict", verdict(comparison, words.tolerance)},
              {"reference", escape(reference.name)},
              {"picture", escape(picture.name)},
              {"stills",
               still(reference.name, reference.picture) + still(picture.name, picture.picture) +
                   still(fmt::format("Difference, {} - {}: blue -{:g}, white 0, red +{:g}",
                                     picture.name, reference.name, scale, scale),
                         difference_map(comparison, scale))},
              {"numbers", numbers(comparison)},
              {"histogram", drawn_histogram(comparison)},
              {"worst", worst_table(comparison, words) + worst_details(comparison, words)},
              {"settings", settings(comparison, words)},
              {"commands", commands(words.commands)},
              {"data", data_for_script(comparison, scale)},
              {"values", base64(pack(reference.picture, picture.picture))}});
    return format_page({.title = words.title,
                        .style = std::string(page_files::comparison_css),
                        .body = body,
                        .script = std::string(page_files::comparison_js)});
}

}  // namespace meniscus::compare
