#include "tracer/pixel_filter.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace meniscus::tracer {
namespace {

constexpr int steps = 1024;  // even, so that none has a filter's centre inside

double blackman_harris(double x, double radius) {
    const double v = glm::pi<double>() * (x / radius + 1.0);
    return 0.35875 - 0.48829 * std::cos(v) + 0.14128 * std::cos(2.0 * v) -
           0.01168 * std::cos(3.0 * v);
}

double mitchell(double x) {
    constexpr double b = 1.0 / 3.0, c = 1.0 / 3.0;
    const double v = std::abs(x);
    if (v < 1.0)
        return ((12 - 9 * b - 6 * c) * v * v * v + (-18 + 12 * b + 6 * c) * v * v + (6 - 2 * b)) /
               6.0;
    return ((-b - 6 * c) * v * v * v + (6 * b + 30 * c) * v * v + (-12 * b - 48 * c) * v +
            (8 * b + 24 * c)) /
           6.0;
}

/// The filter along one axis, not normalised.
double value(PixelFilter filter, double x, double radius) {
    if (std::abs(x) >= radius) return 0.0;
    switch (filter) {
        case PixelFilter::box:
            return 1.0;
        case PixelFilter::blackman_harris:
            return blackman_harris(x, radius);
        case PixelFilter::mitchell:
            return mitchell(x);
    }
    return 0.0;
}

}  // namespace

std::string_view name(PixelFilter filter) {
    switch (filter) {
        case PixelFilter::box:
            return "box";
        case PixelFilter::blackman_harris:
            return "blackman-harris";
        case PixelFilter::mitchell:
            return "mitchell";
    }
    return "";
}

FilterSampler::FilterSampler(PixelFilter filter) : filter_(filter) {
    if (filter == PixelFilter::box) return;
    radius_ = filter == PixelFilter::mitchell ? 2.0 : 1.5;
    const double width = 2.0 * radius_ / steps;
    double sum = 0.0, absolute = 0.0;
    cumulative_.reserve(steps);
    for (int i = 0; i < steps; ++i) {
        const double f = value(filter, (i + 0.5) * width - radius_, radius_);
        sum += f;
        absolute += std::abs(f);
        cumulative_.push_back(absolute);
    }
    for (double& c : cumulative_) c /= absolute;
    integral_ = sum * width;
}

FilterSampler::Offset FilterSampler::offset(double uniform) const {
    const auto at = std::ranges::upper_bound(cumulative_, uniform);
    const auto i = std::min<std::size_t>(std::size_t(at - cumulative_.begin()), steps - 1);
    const double below = i == 0 ? 0.0 : cumulative_[i - 1], share = cumulative_[i] - below;
    const double width = 2.0 * radius_ / steps;
    const double x = (double(i) + (uniform - below) / share) * width - radius_;
    // The table's steps are level, the filter is not: the weight makes up for it.
    const double density = share / width;
    return {x, value(filter_, x, radius_) / (integral_ * density)};
}

FilterSampler::Point FilterSampler::point(const geom::Vec2& uniform) const {
    if (filter_ == PixelFilter::box) return {uniform, 1.0};
    const Offset x = offset(uniform.x), y = offset(uniform.y);
    return {{0.5 + x.x, 0.5 + y.x}, x.weight * y.weight};
}

}  // namespace meniscus::tracer
