#include "bench/result.hpp"

#include <algorithm>

namespace meniscus::bench {

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    const auto middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double Row::median_seconds() const { return median(seconds); }

double Row::nanoseconds_a_segment() const {
    return counts.segments == 0 ? 0.0 : 1e9 * median_seconds() / double(counts.segments);
}

std::vector<std::string> Result::curves() const {
    std::vector<std::string> names;
    for (const auto& row : rows)
        if (std::ranges::find(names, row.contender.curve) == names.end())
            names.push_back(row.contender.curve);
    return names;
}

std::vector<Reach> Result::front(const std::string& curve) const {
    std::vector<Reach> points;
    for (const auto& row : rows)
        if (row.contender.curve == curve && row.failure.empty()) points.push_back(row.reach());
    return pareto_front(std::move(points));
}

void mark_fronts(Result& result) {
    for (const auto& curve : result.curves()) {
        const auto front = result.front(curve);
        for (auto& row : result.rows)
            if (row.contender.curve == curve && row.failure.empty())
                row.is_on_front = std::ranges::find(front, row.reach()) != front.end();
    }
}

}  // namespace meniscus::bench
