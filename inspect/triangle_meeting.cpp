#include "inspect/triangle_meeting.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace meniscus::inspect {
namespace {

using geom::Vec3;

/// Less than this many margins is no length.
constexpr double shortest = 4.0;

double square(const Vec3& v) { return glm::dot(v, v); }

using Heights = std::array<double, 3>;

double snapped(double value, double margin) { return std::abs(value) <= margin ? 0.0 : value; }

Heights heights(const FlatTriangle& of, const FlatTriangle& over, double margin) {
    Heights result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = over.height(of.corners[i], margin);
    return result;
}

bool is_apart(const Heights& h) {
    return std::ranges::all_of(h, [](double x) { return x > 0.0; }) ||
           std::ranges::all_of(h, [](double x) { return x < 0.0; });
}

bool is_flat(const Heights& h) {
    return std::ranges::all_of(h, [](double x) { return x == 0.0; });
}

/// How far the corners reach to the side on which they reach less.
double reach_through(const Heights& h) {
    return std::min(std::max({h[0], h[1], h[2]}), -std::min({h[0], h[1], h[2]}));
}

/// How far inside of an edge a point of the plane lies.
double inside(const FlatTriangle& triangle, std::size_t edge, const Vec3& p, double margin) {
    const Vec3 a = triangle.corners[edge], along = triangle.corners[(edge + 1) % 3] - a;
    return snapped(glm::dot(p - a, glm::cross(triangle.normal, along)) / glm::length(along),
                   margin);
}

struct Chord {
    Vec3 from, to;
    int edge;
};

/// What the other triangle's plane cuts out of one, given its corners' heights over that plane.
std::optional<Chord> chord(const FlatTriangle& triangle, const Heights& h) {
    std::array<Vec3, 6> ends;
    std::size_t count = 0;
    int edge = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Vec3 &a = triangle.corners[i], &b = triangle.corners[j];
        if (h[i] == 0.0) ends[count++] = a;
        if (h[i] * h[j] < 0.0) ends[count++] = a + h[i] / (h[i] - h[j]) * (b - a);
        if (h[i] == 0.0 && h[j] == 0.0) edge = int(i);
    }
    if (count != 2) return std::nullopt;
    return Chord{ends[0], ends[1], edge};
}

TriangleMeeting shared_segment(const FlatTriangle& first, const FlatTriangle& second,
                               const Heights& over_second, const Heights& over_first,
                               double margin) {
    const auto cut = chord(first, over_second);
    if (!cut) return {};
    double low = 0.0, high = 1.0;
    int second_edge = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = inside(second, i, cut->from, margin);
        const double b = inside(second, i, cut->to, margin);
        if (a == 0.0 && b == 0.0) {
            second_edge = int(i);
        } else if (a <= 0.0 && b <= 0.0) {
            return {};
        } else if (a < 0.0) {
            low = std::max(low, a / (a - b));
        } else if (b < 0.0) {
            high = std::min(high, a / (a - b));
        }
    }
    const Vec3 way = cut->to - cut->from;
    if (!((high - low) * glm::length(way) > shortest * margin)) return {};
    return SharedSegment{cut->from + low * way, cut->from + high * way, cut->edge, second_edge,
                         std::min(reach_through(over_second), reach_through(over_first))};
}

using Polygon = std::vector<Vec3>;

/// Sutherland and Hodgman 1974.
Polygon clipped(const Polygon& polygon, const FlatTriangle& by, std::size_t edge, double margin) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = inside(by, edge, a, margin), at_b = inside(by, edge, b, margin);
        if (at_a >= 0.0) result.push_back(a);
        if (at_a * at_b < 0.0) result.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    return result;
}

TriangleMeeting shared_area(const FlatTriangle& first, const FlatTriangle& second, double margin) {
    Polygon common;
    for (const Vec3& corner : first.corners) common.push_back(corner);
    for (std::size_t edge = 0; edge < 3; ++edge) common = clipped(common, second, edge, margin);
    if (common.size() < 3) return {};
    Vec3 area{0.0}, sum{0.0};
    double perimeter = 0.0;
    for (std::size_t i = 0; i < common.size(); ++i) {
        const Vec3 &a = common[i], &b = common[(i + 1) % common.size()];
        area += 0.5 * glm::cross(a - common[0], b - common[0]);
        perimeter += glm::length(b - a);
        sum += a;
    }
    const double width = perimeter > 0.0 ? 2.0 * glm::length(area) / perimeter : 0.0;
    if (!(width > shortest * margin)) return {};
    return SharedArea{sum / double(common.size()), width,
                      glm::dot(first.normal, second.normal) > 0.0};
}

}  // namespace

FlatTriangle::FlatTriangle(const std::array<Vec3, 3>& c) : corners(c) {
    const Vec3 area = glm::cross(c[1] - c[0], c[2] - c[0]);
    const double length = glm::length(area);
    if (!(length > 0.0)) return;
    normal = area / length;
    slimness =
        std::sqrt(std::max({square(c[1] - c[0]), square(c[2] - c[1]), square(c[0] - c[2])})) /
        length;
}

double FlatTriangle::height(const Vec3& p, double margin) const {
    const Vec3 e = p - corners[0];
    return snapped(glm::dot(e, normal), margin * std::max(1.0, slimness * glm::length(e)));
}

TriangleMeeting meet(const FlatTriangle& first, const FlatTriangle& second, double margin) {
    const Vec3 none{0.0};
    if (first.normal == none || second.normal == none) return {};
    const Heights over_second = heights(first, second, margin);
    if (is_apart(over_second)) return {};
    const Heights over_first = heights(second, first, margin);
    if (is_apart(over_first)) return {};
    if (is_flat(over_second) || is_flat(over_first)) return shared_area(first, second, margin);
    return shared_segment(first, second, over_second, over_first, margin);
}

}  // namespace meniscus::inspect
