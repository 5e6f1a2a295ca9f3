#include "bench/ratios.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meniscus::bench {
namespace {

struct Pair {
    std::string peer, curve;
};

bool has(const Result& result, const std::string& curve) {
    return std::ranges::any_of(result.rows,
                               [&](const Row& row) { return row.contender.curve == curve; });
}

std::vector<Pair> pairs(const Result& result) {
    std::vector<Pair> all = {{"POV-Ray, gap", "Meniscus, gap"},
                             {"POV-Ray, gap", "Meniscus, contact"},
                             {"POV-Ray, contact", "Meniscus, contact"}};
    for (const auto* model : {"contact", "gap"}) {
        const auto ours = fmt::format("Meniscus, {}", model), general = ours + ", general";
        all.push_back({general, ours});
        for (const auto* mode : {"recast", "off"})
            all.push_back({fmt::format("{}, {}", ours, mode), general});
    }
    std::erase_if(
        all, [&](const Pair& pair) { return !has(result, pair.peer) || !has(result, pair.curve); });
    return all;
}

double reference_error(const Result& result, const std::string& curve) {
    for (const auto& row : result.rows)
        if (row.contender.curve == curve)
            if (const auto found = result.references.find(row.contender.model);
                found != result.references.end())
                return found->second.rmse;
    return 0.0;
}

/// Three, of equal ratios; none if the fronts share no error.
std::vector<double> choose_errors(const Result& result, const Pair& pair) {
    const auto peer = result.front(pair.peer), front = result.front(pair.curve);
    if (peer.empty() || front.empty()) return {};
    const double low = std::max({2.0 * peer.back().error, front.back().error,
                                 2.0 * reference_error(result, pair.peer),
                                 2.0 * reference_error(result, pair.curve)});
    const double high = std::min(peer.front().error, front.front().error);
    if (!(low < high)) return {};
    return {low, std::sqrt(low * high), high};
}

}  // namespace

std::vector<Ratio> ratios_at_equal_error(const Result& result, const std::vector<double>& errors) {
    std::vector<Ratio> ratios;
    for (const auto& pair : pairs(result)) {
        const auto peer = result.front(pair.peer), front = result.front(pair.curve);
        for (const double error : errors.empty() ? choose_errors(result, pair) : errors) {
            const auto theirs = seconds_at(peer, error), ours = seconds_at(front, error);
            if (theirs && ours)
                ratios.push_back({pair.peer, pair.curve, fmt::format("error {:.3g}", error), error,
                                  *theirs, *ours});
        }
    }
    return ratios;
}

std::vector<Ratio> ratios_of_equal_tasks(const Result& result) {
    std::vector<Ratio> ratios;
    for (const auto& pair : pairs(result)) {
        for (const auto& theirs : result.rows) {
            if (theirs.contender.curve != pair.peer || theirs.contender.task.empty()) continue;
            for (const auto& ours : result.rows) {
                if (ours.contender.curve != pair.curve ||
                    ours.contender.task != theirs.contender.task || ours.seconds.empty() ||
                    theirs.seconds.empty())
                    continue;
                ratios.push_back({pair.peer, pair.curve, theirs.contender.task, 0.0,
                                  theirs.median_seconds(), ours.median_seconds()});
            }
        }
    }
    return ratios;
}

}  // namespace meniscus::bench
