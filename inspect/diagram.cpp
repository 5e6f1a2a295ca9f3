#include "inspect/diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "inspect/side_view.hpp"
#include "inspect/text_report.hpp"

namespace meniscus::inspect {
namespace {

using geom::Vec2;
using geom::Vec3;

constexpr double width = 900.0, margin = 20.0, line_height = 18.0;
constexpr int rows = 360;
constexpr auto colors = std::to_array<std::string_view>(
    {"#1f77b4", "#2ca02c", "#d62728", "#9467bd", "#ff7f0e", "#17becf", "#8c564b", "#e377c2"});

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else if (c == '&') {
            out += "&amp;";
        } else if (c == '"') {
            out += "&quot;";
        } else {
            out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

/// Of a label, on the page.
struct Box {
    double x0, y0, x1, y1;
};
bool overlap(const Box& a, const Box& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

class Diagram {
public:
    Diagram(const tracer::RenderScene& scene, const Names& names, const PixelTrace& trace)
        : scene_(scene), names_(names), trace_(trace), view_(scene.source.camera, trace) {
        scale_ = (width - 2.0 * margin) / view_.size().x;
        height_ = view_.size().y * scale_ + 2.0 * margin;
        solids();
        for (const Segment& segment : trace.segments) line(segment);
        for (const Segment& segment : trace.segments) dots(segment);
    }

    std::string svg() const {
        const double legend = line_height * double(seen_.size() + 2);
        auto out = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
            "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
            "<svg width=\"{0:.0f}\" height=\"{2:.2f}\">\n{3}</svg>\n",
            width, height_ + legend, height_, body_);
        double y = height_ + line_height;
        const auto write = [&](double x, const std::string& text) {
            out += fmt::format("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", x, y, escaped(text));
            y += line_height;
        };
        for (const int solid : seen_) {
            out += fmt::format(
                "<rect x=\"{}\" y=\"{:.1f}\" width=\"14\" height=\"10\" fill=\"{}\"/>\n", margin,
                y - 9.0, color_of(solid));
            write(margin + 22.0, fmt::format("{}, ior {}", names_.with_priority(solid),
                                             text(tracer::medium(scene_, solid).ior)));
        }
        write(margin, fmt::format("Pixel {}, {}: the plane of the camera ray and up; other rays "
                                  "are seen as projected onto it. Filled dots: true crossings; "
                                  "hollow: false.",
                                  trace_.x, trace_.y));
        return out + "</svg>\n";
    }

private:
    /// Colours are handed out in the order of use.
    std::string_view color(int solid) {
        if (std::ranges::find(seen_, solid) == seen_.end()) seen_.push_back(solid);
        return color_of(solid);
    }
    std::string_view color_of(int solid) const {
        if (solid == tracer::outside) return "#777777";
        const auto index = std::ranges::find(seen_, solid) - seen_.begin();
        return colors[std::size_t(index) % colors.size()];
    }

    Vec2 on_page(const Vec2& q) const {
        return {margin + (q.x - view_.low.x) * scale_, margin + (view_.high.y - q.y) * scale_};
    }
    Vec2 on_page(const Vec3& p) const { return on_page(view_.project(p)); }

    void solids() {
        const double row = view_.size().y * scale_ / rows;
        for (const Run& run : cross_section(scene_, view_, rows)) {
            const Vec2 start = on_page(Vec2{run.x0, run.y});
            body_ += fmt::format(
                "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" "
                "fill-opacity=\"{}\"/>\n",
                start.x, start.y - 0.5 * row, (run.x1 - run.x0) * scale_, row, color(run.solid),
                run.is_opaque ? "0.45" : "0.16");
        }
    }

    void line(const Segment& segment) {
        using End = tracer::TreeNode::End;
        const auto& node = segment.node;
        if (node.end == End::depth || node.end == End::weight) return;
        const bool escapes = node.end == End::escape;
        const int medium =
            escapes && !segment.steps.empty() ? segment.steps.back().after.top : segment.start.top;
        const Vec3 start = node.start.ray.origin;
        const double length = 2.0 * (view_.size().x + view_.size().y);
        const Vec3 end = escapes ? node.start.ray.at(length) : node.event.origin.at(0.0);
        const Vec2 a = on_page(start), b = on_page(end);
        body_ += fmt::format(
            "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
            "stroke-width=\"{:.1f}\"{}><title>{}</title></line>\n",
            a.x, a.y, b.x, b.y, color(medium), 0.8 + 1.7 * std::min(node.weight, 1.0),
            escapes ? " stroke-dasharray=\"6 4\"" : "",
            escaped(fmt::format("{}, weight {}, through {}; list: {}", name(node.branch),
                                text(node.weight), names_.solid(medium),
                                text(names_, segment.start))));
    }

    void dots(const Segment& segment) {
        for (const Step& step : segment.steps) {
            const Vec3 p = segment.node.start.ray.at(step.crossings.front().t);
            const Vec2 at = on_page(p);
            const std::string_view ink =
                color(scene_.parts[std::size_t(step.crossings.front().part)].solid);
            std::string label, reasons;
            for (std::size_t i = 0; i < step.crossings.size(); ++i) {
                const auto& crossing = step.crossings[i];
                const int object = scene_.parts[std::size_t(crossing.part)].object;
                label +=
                    (i ? ", " : "") + fmt::format("{} {}", crossing.entering ? "into" : "out of",
                                                  names_.object(object));
                reasons += (i ? "; " : "") + step.why[i];
            }
            body_ += fmt::format(
                "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"{}\" stroke=\"{}\" "
                "stroke-width=\"1.5\"><title>{}</title></circle>\n",
                at.x, at.y, step.is_true ? ink : "white", ink,
                escaped(fmt::format("{}: {}: {}; list: {}", label, step.is_true ? "true" : "false",
                                    reasons, text(names_, step.after))));
            write_label(at, label);
        }
    }

    /// Beside its dot where there is room, else not at all: the dot has a title.
    void write_label(const Vec2& at, const std::string& label) {
        constexpr double font_size = 10.0, mean_width = 5.2;
        for (const double dy : {-8.0, 16.0, -20.0, 28.0, -32.0, 40.0}) {
            const Box box{at.x + 6.0, at.y + dy - font_size,
                          at.x + 6.0 + mean_width * double(label.size()), at.y + dy};
            const auto collides = [&](const Box& other) { return overlap(box, other); };
            if (std::ranges::any_of(labels_, collides)) continue;
            labels_.push_back(box);
            body_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\">{}</text>\n",
                                 box.x0, box.y1, font_size, escaped(label));
            return;
        }
    }

    const tracer::RenderScene& scene_;
    const Names& names_;
    const PixelTrace& trace_;
    SideView view_;
    double scale_ = 1.0, height_ = 0.0;
    std::string body_;
    std::vector<int> seen_;  // the solids that the legend names
    std::vector<Box> labels_;
};

}  // namespace

std::string draw_diagram(const tracer::RenderScene& scene, const Names& names,
                         const PixelTrace& trace) {
    return Diagram(scene, names, trace).svg();
}

}  // namespace meniscus::inspect
