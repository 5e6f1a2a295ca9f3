#include <fmt/format.h>

#include <set>

#include "inspect/lints.hpp"

namespace meniscus::inspect {
namespace {

using tracer::Part;
using tracer::RenderScene;

/// The interior's own words, as a scene would say them: "ior 1.5 priority 3".
std::string words(const scene::Interior& interior) {
    auto words = fmt::format("ior {}", text(interior.ior));
    if (interior.states_priority) words += fmt::format(" priority {}", text(interior.priority));
    if (interior.absorption != scene::Rgb{0.0})
        words += fmt::format(" absorption rgb {}", text(interior.absorption));
    return words;
}

std::string stated(const scene::Interior& interior) {
    if (interior.states_ior && interior.states_priority) return "ior and priority have";
    if (interior.states_ior) return "ior has";
    return interior.states_priority ? "priority has" : "absorption or fading has";
}

std::string how_to_close(const geom::Shape& shape) {
    const auto keyword = geom::keyword(shape);
    if (keyword == "cylinder" || keyword == "cone") return "leave out `open`, or its interior";
    if (keyword == "lathe")
        return "close the profile, on the axis or on itself, or leave out its interior";
    return "leave out its interior, or use a solid: a thin box or cylinder";
}

}  // namespace

void find_media_without_solid(const RenderScene& scene, const Names& names,
                              std::vector<Finding>& findings) {
    for (const Part& part : scene.parts) {
        const auto& interior = scene.source.solids[std::size_t(part.solid)].interior;
        const bool states =
            interior.states_ior || interior.states_priority || interior.attenuates();
        const bool is_mesh = std::holds_alternative<geom::Mesh>(part.shape.shape());
        if (part.shape.is_closed() || is_mesh || !states) continue;
        Finding finding;
        finding.lint = "interior-without-solid";
        finding.location = scene.source.objects[std::size_t(part.object)].location;
        const auto& name = names.object(part.object);
        const auto keyword = geom::keyword(part.shape.shape());
        finding.text = fmt::format("{}{} is a surface and never a solid: its {} no effect", name,
                                   name.starts_with(keyword) ? "" : fmt::format(" ({})", keyword),
                                   stated(interior));
        finding.advice = how_to_close(part.shape.shape());
        findings.push_back(std::move(finding));
    }
}

void find_hidden_iors(const RenderScene& scene, const Names& names,
                      std::vector<Finding>& findings) {
    std::set<int> seen;
    for (const Part& part : scene.parts) {
        const auto& interior = scene.source.solids[std::size_t(part.solid)].interior;
        const auto& object = scene.source.objects[std::size_t(part.object)];
        const auto& finish = scene.source.textures[object.texture].finish;
        if (!part.is_opaque || !part.shape.is_closed() || !interior.states_ior) continue;
        if (finish.reflection.fresnel) continue;  // which needs an ior
        if (!seen.insert(part.solid).second) continue;
        Finding finding;
        finding.lint = "opaque-ior";
        finding.location = object.location;
        finding.text = fmt::format("{} has ior {}, but its texture is opaque: no light enters it",
                                   names.object(part.object), text(interior.ior));
        finding.advice = fmt::format(
            "for clear glass write `material {{ {} }}` in place of texture and interior; or give "
            "the pigment transmit or filter",
            words(interior));
        findings.push_back(std::move(finding));
    }
}

}  // namespace meniscus::inspect
