#pragma once

#include <nlohmann/json.hpp>

#include "compare/comparison.hpp"

namespace meniscus::compare {

using Json = nlohmann::ordered_json;

/// The same as `format_text` says, as data.
Json to_json(const Metrics& metrics);
Json to_json(const Comparison& comparison);

/// As text. Names of files may hold bytes that are not UTF-8.
inline std::string dump(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace meniscus::compare
