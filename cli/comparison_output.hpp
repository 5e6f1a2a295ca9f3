#pragma once

#include "cli/compare_options.hpp"
#include "cli/scene_comparison.hpp"
#include "compare/json_report.hpp"

namespace meniscus::cli {

/// One comparison to standard output, into `json`, and to the files that were asked for; whether it
/// is within the tolerance.
bool write_comparison(const CompareOptions& options, SceneComparison& result,
                      const std::vector<std::string>& inputs, compare::Json& json);

}  // namespace meniscus::cli
