#include "inspect/json_report.hpp"

#include "inspect/text_report.hpp"

namespace meniscus::inspect {
namespace {

using tracer::TreeNode;

Json to_json(const geom::Vec3& v) { return {v.x, v.y, v.z}; }

std::string_view end_name(TreeNode::End end) {
    switch (end) {
        case TreeNode::End::surface:
            return "surface";
        case TreeNode::End::escape:
            return "escape";
        case TreeNode::End::depth:
            return "depth";
        case TreeNode::End::weight:
            return "weight";
    }
    return "";
}

Json to_json(const Names& names, const Listing& listing) {
    Json list = Json::array();
    for (const auto& member : listing.members) {
        Json entry{{"solid", names.solid(member.solid)}};
        if (member.depth > 1) entry["depth"] = member.depth;
        list.push_back(entry);
    }
    return list;
}

Json crossings(const tracer::RenderScene& scene, const Names& names, const Segment& segment) {
    Json list = Json::array();
    for (const Step& step : segment.steps) {
        for (std::size_t i = 0; i < step.crossings.size(); ++i) {
            const auto& crossing = step.crossings[i];
            const auto& part = scene.parts[std::size_t(crossing.part)];
            const auto& location = scene.source.objects[std::size_t(part.object)].location;
            list.push_back({{"t", crossing.t},
                            {"object", names.object(part.object)},
                            {"file", location.file},
                            {"line", location.line},
                            {"entering", crossing.entering},
                            {"true", crossing.is_true},
                            {"why", step.why[i]},
                            {"together", step.crossings.size()},
                            {"list_before", to_json(names, step.before)},
                            {"list_after", to_json(names, step.after)},
                            {"top_before", names.solid(step.before.top)},
                            {"top_after", names.solid(step.after.top)}});
        }
    }
    return list;
}

Json surface(const tracer::RenderScene& scene, const Names& names, const Segment& segment) {
    const TreeNode& node = segment.node;
    const auto& event = node.event;
    const auto object = [&](int part) {
        return names.object(scene.parts[std::size_t(part)].object);
    };
    return {{"t", event.t},
            {"position", to_json(event.origin.at(0.0))},
            {"normal", to_json(event.normal)},
            {"object", object(event.part)},
            {"skin", object(event.skin)},
            {"from", names.solid(event.solid_before)},
            {"to", names.solid(event.solid_after)},
            {"passed", !node.is_surface},
            {"ior_before", node.ior_before},
            {"ior_after", node.ior_after},
            {"incidence_degrees", node.angle_degrees},
            {"reflectance", to_json(node.reflectance)},
            {"transmittance", to_json(node.transmittance)},
            {"total_reflection", node.total_reflection},
            {"way", segment.way},
            {"absorption", to_json(segment.absorption)}};
}

Json to_json(const tracer::RenderScene& scene, const Names& names, const Segment& segment) {
    const TreeNode& node = segment.node;
    Json json{{"branch", name(node.branch)},
              {"parent", node.parent},
              {"level", node.level},
              {"weight", node.weight},
              {"throughput", to_json(node.throughput)},
              {"origin", to_json(node.start.ray.origin)},
              {"direction", to_json(node.start.ray.direction)},
              {"list", to_json(names, segment.start)},
              {"top", names.solid(segment.start.top)},
              {"crossings", crossings(scene, names, segment)},
              {"end", end_name(node.end)}};
    if (segment.ends_at_surface()) json["surface"] = surface(scene, names, segment);
    json["own_color"] = to_json(node.own_color);
    json["adds"] = to_json(segment.adds);
    return json;
}

}  // namespace

Json format_json(const tracer::RenderScene& scene, const Names& names, const PixelTrace& trace) {
    Json segments = Json::array();
    for (const Segment& segment : trace.segments)
        segments.push_back(to_json(scene, names, segment));
    return {{"pixel", {trace.x, trace.y}},
            {"width", trace.width},
            {"height", trace.height},
            {"tree", tracer::name(trace.tree)},
            {"interior", tracer::name(trace.interior)},
            {"color", to_json(trace.color)},
            {"light", to_json(trace.light)},
            {"leaks", trace.leaks},
            {"segments", std::move(segments)}};
}

}  // namespace meniscus::inspect
