#include "bench/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace meniscus::bench {

std::vector<Reach> pareto_front(std::vector<Reach> points) {
    std::erase_if(points, [](const Reach& point) {
        return !(point.seconds > 0.0 && point.error > 0.0 && std::isfinite(point.seconds) &&
                 std::isfinite(point.error));
    });
    std::ranges::sort(points, [](const Reach& a, const Reach& b) {
        return std::tie(a.seconds, a.error) < std::tie(b.seconds, b.error);
    });
    std::vector<Reach> front;
    for (const auto& point : points)
        if (front.empty() || point.error < front.back().error) front.push_back(point);
    return front;
}

std::optional<double> seconds_at(const std::vector<Reach>& front, double error) {
    if (front.empty() || !(error <= front.front().error && error >= front.back().error))
        return std::nullopt;
    const auto after =
        std::ranges::find_if(front, [&](const Reach& point) { return point.error <= error; });
    if (after->error == error) return after->seconds;
    const auto before = after - 1;
    const double share = std::log(before->error / error) / std::log(before->error / after->error);
    return before->seconds * std::pow(after->seconds / before->seconds, share);
}

}  // namespace meniscus::bench
