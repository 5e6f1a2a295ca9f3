#include "compare/json_report.hpp"

namespace meniscus::compare {
namespace {

Json to_json(const Side& side) {
    Json json{{"name", side.name}};
    for (const auto& [name, value] : side.facts) json["facts"][name] = value;
    if (!side.command.empty()) json["command"] = side.command;
    return json;
}

}  // namespace

Json to_json(const Metrics& metrics) {
    return {{"pixels", metrics.pixels},
            {"rmse", metrics.rmse},
            {"largest", metrics.largest},
            {"bias", metrics.bias},
            {"off", metrics.off},
            {"share_off", metrics.share_off()},
            {"not_finite", metrics.not_finite}};
}

Json to_json(const Comparison& comparison) {
    Json json;
    json["reference"] = to_json(comparison.reference);
    json["picture"] = to_json(comparison.picture);
    json["window"] = {{"x", comparison.x0()},
                      {"y", comparison.y0()},
                      {"width", comparison.width()},
                      {"height", comparison.height()}};
    json["threshold"] = comparison.settings.threshold;
    json["clipped"] = comparison.settings.clip;
    json["all"] = to_json(comparison.all);
    for (std::size_t i = 0; i < comparison.by_region.size(); ++i)
        json["regions"][comparison.regions.parts[i].name] = to_json(comparison.by_region[i]);
    json["regions_by"] = comparison.regions.how;
    json["worst"] = Json::array();
    for (const auto& pixel : comparison.worst)
        json["worst"].push_back({{"x", pixel.x}, {"y", pixel.y}, {"error", pixel.error}});
    return json;
}

}  // namespace meniscus::compare
