#include "bench/format.hpp"
#include "bench/machine.hpp"
#include "compare/json_report.hpp"

namespace meniscus::bench {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Row& row) {
    Json json{{"curve", row.contender.curve},
              {"options", row.contender.options},
              {"model", name(row.contender.model)}};
    if (!row.failure.empty()) {
        json["failure"] = row.failure;
        return json;
    }
    json["on_front"] = row.is_on_front;
    json["error"] = compare::to_json(row.error);
    if (row.estimated_error) json["estimated_error"] = *row.estimated_error;
    json["cpu_seconds"] = row.median_seconds();
    json["runs"] = row.seconds;
    if (row.contender.is_povray()) return json;
    json["kernel"] = row.kernel;
    const auto& n = row.counts;
    json["samples"] = n.samples;
    json["rays"] = {{"camera", n.camera_rays},
                    {"reflected", n.reflected_rays},
                    {"refracted", n.refracted_rays},
                    {"shadow", n.shadow_rays}};
    json["casts"] = n.casts;
    json["segments"] = n.segments;
    json["crossings"] = {{"true", n.true_crossings}, {"false", n.false_crossings}};
    json["ns_a_segment"] = row.nanoseconds_a_segment();
    return json;
}

Json to_json(const std::vector<Ratio>& ratios) {
    auto list = Json::array();
    for (const auto& ratio : ratios) {
        Json json{{"curve", ratio.curve}, {"peer", ratio.peer}, {"at", ratio.at}};
        if (ratio.error > 0.0) json["error"] = ratio.error;
        json["cpu_seconds"] = ratio.seconds;
        json["peer_cpu_seconds"] = ratio.peer_seconds;
        json["ratio"] = ratio.value();
        list.push_back(json);
    }
    return list;
}

}  // namespace

Json to_json(const Report& report) {
    const auto& result = report.result;
    Json json{{"scene", result.scene},     {"machine", machine_name()},
              {"width", result.width},     {"height", result.height},
              {"threads", result.threads}, {"clipped", result.is_clipped},
              {"gap", result.gap},         {"interrupted", result.is_interrupted}};
    for (const auto& [model, reference] : result.references)
        json["references"][name(model)] = {{"samples", reference.samples},
                                           {"depth", reference.depth},
                                           {"rmse", reference.rmse},
                                           {"bias", reference.bias}};
    json["rows"] = Json::array();
    for (const auto& row : result.rows) json["rows"].push_back(to_json(row));
    json["at_equal_error"] = to_json(report.at_equal_error);
    json["of_equal_tasks"] = to_json(report.of_equal_tasks);
    return json;
}

}  // namespace meniscus::bench
