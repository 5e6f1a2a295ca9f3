#include "compare/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "compare/markup.hpp"

namespace meniscus::compare {
namespace {

constexpr double width = 720.0, left = 78.0, right = 20.0, top = 44.0, plot_height = 320.0;
constexpr double axis_room = 58.0, line_height = 21.0;

/// Colours that people with any colour vision tell apart (Okabe and Ito 2008), darkened for paper;
/// each with a mark of its own as well.
constexpr std::array<std::string_view, 6> colors = {"#0072b2", "#c24e00", "#008560",
                                                    "#b05a8c", "#9a6b00", "#2f7fb0"};

constexpr std::string_view style = R"(<style>
.plot text { font: 13px system-ui, "DejaVu Sans", sans-serif; fill: #1c2128; }
.plot .title { font-size: 15px; font-weight: 600; }
.plot .grid { stroke: #d0d7de; }
.plot .frame { stroke: #57606a; fill: none; }
.plot .bar { fill: #0072b2; }
@media (prefers-color-scheme: dark) {
    .plot text { fill: #e6e9ee; }
    .plot .grid { stroke: #3a424d; }
    .plot .frame { stroke: #9aa4b1; }
    .plot .curve { filter: brightness(1.5); }
    .plot .bar { fill: #4ea1dd; }
}
@media print {
    .plot text { fill: #000000; }
}
</style>
)";

/// "10⁻³".
std::string power_of_ten(int exponent) {
    constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[std::size_t(c - '0')];
    return text;
}

/// Whole decades of a logarithmic axis, laid on a stretch of the page.
struct Axis {
    int low = 0, high = 1;  // exponents
    double start = 0.0, end = 1.0;

    double place(double value) const {
        return start + (end - start) * (std::log10(value) - low) / (high - low);
    }
    /// Every so many decades one is named, so that names do not touch.
    int step() const { return std::max(1, (high - low + 9) / 10); }
};

Axis make_axis(const std::vector<double>& values, double start, double end) {
    Axis axis{0, 1, start, end};
    if (values.empty()) return axis;
    const auto [least, most] = std::ranges::minmax_element(values);
    axis.low = int(std::floor(std::log10(*least) + 1e-9));
    axis.high = std::max(axis.low + 1, int(std::ceil(std::log10(*most) - 1e-9)));
    return axis;
}

struct Words {
    const std::string &title, &x_label, &y_label;
};

void draw_head(std::string& out, double height, const Words& words) {
    fmt::format_to(std::back_inserter(out),
                   "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
                   "aria-label=\"{2}\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n{3}",
                   width, height, escape(words.title), style);
    fmt::format_to(std::back_inserter(out),
                   "<text class=\"title\" x=\"{}\" y=\"24\">{}</text>\n"
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" "
                   "transform=\"rotate(-90 {} {})\">{}</text>\n",
                   left, escape(words.title), 0.5 * (left + width - right),
                   top + plot_height + 44.0, escape(words.x_label), 18.0, top + 0.5 * plot_height,
                   18.0, top + 0.5 * plot_height, escape(words.y_label));
}

void draw_frame(std::string& out) {
    fmt::format_to(std::back_inserter(out),
                   "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left,
                   top, width - left - right, plot_height);
}

void draw_y_axis(std::string& out, const Axis& axis) {
    for (int e = axis.low; e <= axis.high; ++e) {
        const double y = axis.place(std::pow(10.0, e));
        fmt::format_to(std::back_inserter(out), "<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n",
                       left, y, width - right);
        if ((e - axis.low) % axis.step() == 0)
            fmt::format_to(std::back_inserter(out),
                           "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                           left - 8.0, y + 4.5, power_of_ten(e));
    }
}

void draw_x_axis(std::string& out, const Axis& axis) {
    for (int e = axis.low; e <= axis.high; ++e) {
        const double x = axis.place(std::pow(10.0, e));
        fmt::format_to(std::back_inserter(out), "<path class=\"grid\" d=\"M{:.1f} {}v{}\"/>\n", x,
                       top, plot_height);
        if ((e - axis.low) % axis.step() == 0)
            fmt::format_to(std::back_inserter(out),
                           "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x,
                           top + plot_height + 20.0, power_of_ten(e));
    }
}

/// Circle, square, triangle, diamond in turn.
std::string mark(std::size_t kind, double x, double y) {
    switch (kind % 4) {
        case 0:
            return fmt::format("M{:.1f} {:.1f}m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", x, y);
        case 1:
            return fmt::format("M{:.1f} {:.1f}m-4 -4h8v8h-8z", x, y);
        case 2:
            return fmt::format("M{:.1f} {:.1f}m0 -5l5 9h-10z", x, y);
        default:
            return fmt::format("M{:.1f} {:.1f}m0 -5.5l5.5 5.5l-5.5 5.5l-5.5 -5.5z", x, y);
    }
}

void draw_series(std::string& out, const Series& series, std::size_t kind, const Axis& x_axis,
                 const Axis& y_axis) {
    std::string line, marks;
    for (const auto& point : series.line.value_or(series.points))
        if (point.x > 0.0 && point.y > 0.0)
            line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x_axis.place(point.x),
                                y_axis.place(point.y));
    for (const auto& point : series.points)
        if (series.marks && point.x > 0.0 && point.y > 0.0)
            marks += mark(kind, x_axis.place(point.x), y_axis.place(point.y));
    const auto color = colors[kind % colors.size()];
    fmt::format_to(std::back_inserter(out),
                   "<g class=\"curve\"><title>{}</title><path fill=\"none\" stroke=\"{}\" "
                   "stroke-width=\"2\"{} d=\"{}\"/>",
                   escape(series.name), color, series.dashed ? " stroke-dasharray=\"7 5\"" : "",
                   line);
    if (!marks.empty())
        fmt::format_to(std::back_inserter(out), "<path fill=\"{}\" d=\"{}\"/>", color, marks);
    out += "</g>\n";
}

void draw_legend_line(std::string& out, const Series& series, std::size_t kind, double y) {
    const auto color = colors[kind % colors.size()];
    fmt::format_to(
        std::back_inserter(out),
        "<g class=\"curve\"><path stroke=\"{0}\" stroke-width=\"2\"{1} d=\"M{2} "
        "{3}h34\"/>{4}</g><text x=\"{5}\" y=\"{6}\">{7}</text>\n",
        color, series.dashed ? " stroke-dasharray=\"7 5\"" : "", left, y,
        series.marks ? fmt::format("<path fill=\"{}\" d=\"{}\"/>", color, mark(kind, left + 17, y))
                     : "",
        left + 44.0, y + 4.5, escape(series.name));
}

}  // namespace

std::string draw(const Plot& plot) {
    std::vector<double> xs, ys;
    for (const auto& series : plot.series) {
        for (const auto& point : series.points) {
            if (!(point.x > 0.0 && point.y > 0.0)) continue;
            xs.push_back(point.x);
            ys.push_back(point.y);
        }
    }
    const auto x_axis = make_axis(xs, left, width - right);
    const auto y_axis = make_axis(ys, top + plot_height, top);
    const double legend = top + plot_height + axis_room + 0.5 * line_height;
    std::string out;
    draw_head(out, legend + line_height * double(plot.series.size()),
              {plot.title, plot.x_label, plot.y_label});
    draw_x_axis(out, x_axis);
    draw_y_axis(out, y_axis);
    draw_frame(out);
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        draw_series(out, plot.series[i], i, x_axis, y_axis);
        draw_legend_line(out, plot.series[i], i, legend + line_height * double(i));
    }
    return out + "</svg>\n";
}

std::string draw(const Bars& bars) {
    std::vector<double> counts{1.0};
    for (const auto& bar : bars.bars)
        if (bar.count > 0.0) counts.push_back(bar.count);
    const auto axis = make_axis(counts, top + plot_height, top + 8.0);
    std::string out;
    draw_head(out, top + plot_height + axis_room, {bars.title, bars.x_label, bars.y_label});
    draw_y_axis(out, axis);
    draw_frame(out);
    // A bar of a single pixel must be seen too: all begin a little below the axis' first power.
    const double step = (width - left - right) / double(std::max<std::size_t>(1, bars.bars.size()));
    for (std::size_t i = 0; i < bars.bars.size(); ++i) {
        const auto& bar = bars.bars[i];
        const double x = left + step * double(i);
        if (!bar.label.empty())
            fmt::format_to(std::back_inserter(out),
                           "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                           x + 0.5 * step, top + plot_height + 20.0, escape(bar.label));
        if (bar.count <= 0.0) continue;
        const double y = std::min(axis.place(bar.count), axis.start - 3.0);
        fmt::format_to(std::back_inserter(out),
                       "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
                       "height=\"{:.1f}\"><title>{}: {:g}</title></rect>\n",
                       x + 1.5, y, step - 3.0, axis.start - y, escape(bar.what), bar.count);
    }
    return out + "</svg>\n";
}

}  // namespace meniscus::compare
