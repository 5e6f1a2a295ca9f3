#pragma once

#include <optional>
#include <vector>

namespace meniscus::bench {

/// What a renderer reaches with one setting.
struct Reach {
    double seconds, error;
    bool operator==(const Reach&) const = default;
};

/// Those that no other beats in both time and error (of equal ones, one): the fastest first, errors
/// falling strictly. Points that a logarithm does not know (0, infinite) are left out.
std::vector<Reach> pareto_front(std::vector<Reach> points);

/// The time at which a front reaches an error: a straight line between neighbours in logarithms of
/// both. Nothing for errors that the front does not span.
std::optional<double> seconds_at(const std::vector<Reach>& front, double error);

}  // namespace meniscus::bench
