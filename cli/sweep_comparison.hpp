#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/scene_options.hpp"
#include "compare/sweep.hpp"

namespace meniscus::cli {

struct SweepOptions {
    SceneOptions scene;  // the solids in contact: the truth
    std::string gapped;  // the same with a gap of `Gap`, for both; empty: the gap model's export
    std::vector<double> gaps;
    std::optional<double> scale;  // of the export
    double threshold = 0.01;
};

/// "1e-1:1e-9", or "1e-1:1e-9:2" for two steps a decade. Throws `UsageError`.
std::vector<double> parse_gaps(const std::string& text);

/// Renders all gaps and a gap of 0, where faces coincide, by both. Prints a line of progress for
/// each to standard error. Throws povray::RunFailed if POV-Ray renders none of them.
compare::Sweep sweep_gaps(const SweepOptions& options);

}  // namespace meniscus::cli
