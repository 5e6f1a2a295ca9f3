#pragma once

#include <nlohmann/json.hpp>

#include "inspect/pixel_trace.hpp"

namespace meniscus::inspect {

using Json = nlohmann::ordered_json;

/// The same as `format_text` says, as data.
Json format_json(const tracer::RenderScene& scene, const Names& names, const PixelTrace& trace);

/// As text. Names from a scene may hold bytes that are not UTF-8.
inline std::string dump(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace meniscus::inspect
