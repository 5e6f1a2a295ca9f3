#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/result.hpp"

namespace meniscus::bench {

/// How many times faster a curve is than its peer.
struct Ratio {
    std::string peer, curve;
    std::string at;      // "error 0.019", or the task that both did
    double error = 0.0;  // 0: of one task
    double peer_seconds = 0.0, seconds = 0.0;
    double value() const { return peer_seconds / seconds; }
};

/// At equal error, read off the Pareto fronts: against POV-Ray in the same model, in contact
/// against POV-Ray's gap, of lanes against the general kernel, and of that against the other
/// interior modes. Without `errors` at three for each pair: from twice the peer's lowest (and no
/// less than twice the reference's own error) to the largest that both have. What a front does not
/// span is left out.
std::vector<Ratio> ratios_at_equal_error(const Result& result, const std::vector<double>& errors);

/// Of contenders of those pairs that did the same task.
std::vector<Ratio> ratios_of_equal_tasks(const Result& result);

}  // namespace meniscus::bench
