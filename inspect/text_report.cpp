#include "inspect/text_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meniscus::inspect {
namespace {

using tracer::TreeNode;

/// Of one segment; lines come without indentation.
class Paragraph {
public:
    Paragraph(const tracer::RenderScene& scene, const Names& names, const PixelTrace& trace,
              std::size_t index)
        : scene_(scene),
          names_(names),
          segment_(trace.segments[index]),
          node_(segment_.node),
          has_list_(trace.interior != tracer::InteriorMode::off) {
        header(index);
        if (node_.end == TreeNode::End::depth) {
            add("  not followed: the tree's depth ends here");
        } else if (node_.end == TreeNode::End::weight) {
            add("  not followed: its weight is too low");
        } else {
            list(segment_.start);
            for (const Step& step : segment_.steps) crossings(step);
            segment_.ends_at_surface() ? surface() : sky();
        }
    }

    const std::vector<std::string>& lines() const { return lines_; }

private:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        lines_.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
    }

    std::string medium_name(int solid) const {
        return fmt::format("{} (ior {})", names_.solid(solid),
                           text(tracer::medium(scene_, solid).ior));
    }

    void header(std::size_t index) {
        auto line = fmt::format("{}: {}", index, name(node_.branch));
        if (node_.parent >= 0) line += fmt::format(" from {}", node_.parent);
        add("{}, weight {}, throughput {}", line, text(node_.weight),
            text_of_color(node_.throughput));
        const auto& ray = node_.start.ray;
        add("  from {} towards {}", text(ray.origin), text(ray.direction));
    }

    void list(const Listing& listing) {
        if (has_list_) add("  list: {}", text(names_, listing));
    }

    void crossings(const Step& step) {
        for (std::size_t i = 0; i < step.crossings.size(); ++i) {
            const auto& crossing = step.crossings[i];
            const int object = scene_.parts[std::size_t(crossing.part)].object;
            const auto where = place(scene_.source.objects[std::size_t(object)].location);
            const auto verdict = !crossing.is_true ? "false" : node_.is_surface ? "true" : "passed";
            add("  t {}: {} {}{}, {}: {}", text(crossing.t),
                crossing.entering ? "enters" : "leaves", names_.object(object),
                where.empty() ? "" : " (" + where + ")", verdict, step.why[i]);
        }
        list(step.after);
    }

    void way(int solid) {
        const bool absorbs = tracer::medium(scene_, solid).attenuates();
        add("  way: {} through {}{}", text(segment_.way), medium_name(solid),
            absorbs ? ", transmittance " + text_of_color(segment_.absorption) : "");
    }

    void interface(const tracer::Event& event) {
        add("  {} -> {}: n {} -> {}, incidence {} degrees, {}", names_.solid(event.solid_before),
            names_.solid(event.solid_after), text(node_.ior_before), text(node_.ior_after),
            text(node_.angle_degrees),
            node_.total_reflection ? "total reflection"
                                   : fmt::format("R {}, T {}", text_of_color(node_.reflectance),
                                                 text_of_color(node_.transmittance)));
    }

    void surface() {
        const auto& event = node_.event;
        if (!node_.is_surface) {
            add("  passed: both sides are alike, nothing is seen at {}",
                text(event.origin.at(0.0)));
            return;
        }
        way(event.solid_before);
        const auto object = [&](int part) {
            return names_.object(scene_.parts[std::size_t(part)].object);
        };
        add("  surface of {} at {}{}", object(event.part), text(event.origin.at(0.0)),
            event.skin == event.part ? "" : ", looks like " + object(event.skin));
        if (!node_.total_reflection && node_.reflectance == scene::Rgb{0.0} &&
            node_.transmittance == scene::Rgb{0.0}) {
            add("  nothing is reflected or passes");
        } else {
            interface(event);
        }
        if (node_.own_color != scene::Rgb{0.0}) {
            add("  own light {}, adds {}", text_of_color(node_.own_color),
                text_of_color(segment_.adds));
        }
    }

    void sky() {
        const int solid =
            segment_.steps.empty() ? segment_.start.top : segment_.steps.back().after.top;
        add("  escapes to the sky through {}: {}, adds {}", medium_name(solid),
            text_of_color(node_.own_color), text_of_color(segment_.adds));
    }

    const tracer::RenderScene& scene_;
    const Names& names_;
    const Segment& segment_;
    const TreeNode& node_;
    bool has_list_;
    std::vector<std::string> lines_;
};

}  // namespace

std::string_view name(TreeNode::Branch branch) {
    switch (branch) {
        case TreeNode::Branch::camera:
            return "camera ray";
        case TreeNode::Branch::reflected:
            return "reflected";
        case TreeNode::Branch::refracted:
            return "refracted";
        case TreeNode::Branch::straight:
            return "straight on";
    }
    return "";
}

std::string format_text(const tracer::RenderScene& scene, const Names& names,
                        const PixelTrace& trace) {
    auto out = fmt::format("pixel {}, {} of {} x {}, tree {}, interior {}\n", trace.x, trace.y,
                           trace.width, trace.height, tracer::name(trace.tree),
                           tracer::name(trace.interior));
    for (std::size_t i = 0; i < trace.segments.size(); ++i) {
        const std::string indentation(std::size_t(2 * trace.segments[i].nesting), ' ');
        out += '\n';
        const Paragraph paragraph(scene, names, trace, i);
        for (const auto& line : paragraph.lines()) {
            out += indentation + line + '\n';
        }
    }
    out += fmt::format("\ncolour {}, linear\n", text(trace.light));
    if (!scene.source.settings.working_space.is_linear())
        out += fmt::format("  of {}, which by assumed_gamma is no light\n", text(trace.color));
    if (trace.leaks > 0) out += fmt::format("leaks {}\n", trace.leaks);
    return out;
}

}  // namespace meniscus::inspect
