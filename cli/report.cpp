#include "cli/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/version.hpp"

namespace meniscus::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string object_name(const Report& report, std::size_t object) {
    const auto& objects = report.render_scene.source.objects;
    return object < objects.size() ? objects[object].name : std::string("the outside");
}

Json object_place(const Report& report, std::size_t object) {
    const auto& objects = report.render_scene.source.objects;
    Json json{{"object", object_name(report, object)}};
    if (object < objects.size()) {
        json["file"] = objects[object].location.file;
        json["line"] = objects[object].location.line;
    }
    return json;
}

Json leaks_by_object(const Report& report) {
    Json list = Json::array();
    for (const auto& [key, count] : report.rendered.statistics.leaks_by_object) {
        auto entry = object_place(report, key.first);
        entry["kind"] = key.second;
        entry["count"] = count;
        list.push_back(entry);
    }
    return list;
}

Json first_leaks(const Report& report) {
    Json list = Json::array();
    for (const auto& leak : report.rendered.statistics.first_leaks) {
        auto entry = object_place(report, leak.object);
        entry["kind"] = leak.kind;
        entry["position"] = {leak.position.x, leak.position.y, leak.position.z};
        list.push_back(entry);
    }
    return list;
}

Json warnings(const Report& report) {
    Json list = Json::array();
    for (const auto& warning : report.warnings)
        list.push_back({{"file", warning.location.file},
                        {"line", warning.location.line},
                        {"column", warning.location.column},
                        {"text", warning.text}});
    return list;
}

/// "12", "34.5 thousand", "1.20 million".
std::string in_words(double count) {
    if (count < 1e4) return fmt::format("{:.0f}", count);
    if (count < 1e6) return fmt::format("{:.1f} thousand", count / 1e3);
    return fmt::format("{:.2f} million", count / 1e6);
}

std::string leak_lines(const Report& report) {
    const auto& statistics = report.rendered.statistics;
    if (statistics.leaks == 0) return "leaks      0\n";
    auto text = fmt::format("leaks      {}\n", statistics.leaks);
    for (const auto& [key, count] : statistics.leaks_by_object)
        text += fmt::format("           {} of '{}': {}\n", count, object_name(report, key.first),
                            key.second);
    if (!statistics.first_leaks.empty()) {
        const auto& p = statistics.first_leaks.front().position;
        text += fmt::format("           the first at <{}, {}, {}>\n", p.x, p.y, p.z);
    }
    return text;
}

std::string kernel(const tracer::Rendered& rendered) {
    return rendered.why_general.empty() ? "lanes" : "general: " + rendered.why_general;
}

}  // namespace

std::string format_statistics(const Report& report) {
    const auto& rendered = report.rendered;
    const auto& s = rendered.statistics;
    const double pixels = double(rendered.picture.width) * rendered.picture.height;
    auto text = fmt::format("picture    {} x {}, tree {}, {:.4g} samples a pixel", report.width,
                            report.height, name(rendered.tree), double(s.samples) / pixels);
    if (const auto error = rendered.estimated_error)
        text += fmt::format(", estimated error {:.2g}", *error);
    text += fmt::format("\nrays       camera {}, reflected {}, refracted {}, shadow {}\n",
                        s.camera_rays, s.reflected_rays, s.refracted_rays, s.shadow_rays);
    text += fmt::format("casts      {}", in_words(double(s.casts)));
    if (report.render.wall > 0.0)
        text += fmt::format(", {} a second", in_words(double(s.casts) / report.render.wall));
    text += fmt::format("\nkernel     {}", kernel(rendered));
    text += fmt::format("\ncrossings  true {}, false {}\n", s.true_crossings, s.false_crossings);
    text += leak_lines(report);
    text +=
        fmt::format("seconds    parse {:.2f}, build {:.2f}, render {:.2f} (CPU {:.2f})\n",
                    report.parse.wall, report.build.wall, report.render.wall, report.render.cpu);
    text += fmt::format("memory     {:.0f} MB\n", double(peak_bytes()) / 1e6);
    for (const auto& skipped : report.render_scene.skipped)
        text += fmt::format("skipped    {}\n", skipped);
    return text;
}

std::string format_json(const Report& report) {
    const auto& rendered = report.rendered;
    const auto& s = rendered.statistics;
    Json json;
    json["version"] = version;
    json["scene"] = report.scene;
    json["options"] = report.options;
    json["width"] = report.width;
    json["height"] = report.height;
    json["tree"] = name(rendered.tree);
    json["samples"] = s.samples;
    json["estimated_error"] = nullptr;
    if (const auto error = rendered.estimated_error) json["estimated_error"] = *error;
    json["reproduce"] = rendered.reproduce;
    json["interrupted"] = rendered.interrupted;
    json["rays"] = {{"camera", s.camera_rays},
                    {"reflected", s.reflected_rays},
                    {"refracted", s.refracted_rays},
                    {"shadow", s.shadow_rays}};
    json["kernel"] = kernel(rendered);
    json["single_rays"] = s.single_rays;
    json["casts"] = s.casts;
    json["segments"] = s.segments;
    json["deepest_level"] = s.deepest_level;
    json["crossings"] = {{"true", s.true_crossings}, {"false", s.false_crossings}};
    json["leaks"] = s.leaks;
    json["leaks_by_object"] = leaks_by_object(report);
    json["first_leaks"] = first_leaks(report);
    json["seconds"] = {
        {"parse", report.parse.wall}, {"build", report.build.wall}, {"render", report.render.wall}};
    json["cpu_seconds"] = {
        {"parse", report.parse.cpu}, {"build", report.build.cpu}, {"render", report.render.cpu}};
    json["peak_bytes"] = peak_bytes();
    json["skipped"] = report.render_scene.skipped;
    json["warnings"] = warnings(report);
    // Names from a scene may hold bytes that are not UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace meniscus::cli
