#include "inspect/meeting.hpp"

#include <algorithm>
#include <cmath>

#include "inspect/sample_lines.hpp"
#include "tracer/offers.hpp"

namespace meniscus::inspect {
namespace {

using geom::Vec3;
using tracer::Part;

/// Whether a point lies inside by more than `margin`, whatever the direction.
bool is_well_inside(const Part& part, const Vec3& p, double margin) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 step{0.0};
        step[axis] = margin;
        if (part.shape.contains(p + step) == part.inverse) return false;
        if (part.shape.contains(p - step) == part.inverse) return false;
    }
    return part.shape.contains(p) != part.inverse;
}

double magnitude(const Part& a, const Part& b, const Vec3& p) {
    return geom::max_abs(p) + std::max(a.shape.magnitude(), b.shape.magnitude());
}

/// The middle of what both share of a line, if there is enough of it.
std::optional<Vec3> shared_point(const tracer::RenderScene& scene, const Part& a, const Part& b,
                                 const geom::Ray& line, const Inside& in_a, const Inside& in_b) {
    const double reach = 2.0 * scene.size;  // of endless stretches
    const double begin = std::max({in_a.begin, in_b.begin, -reach});
    const double end = std::min({in_a.end, in_b.end, reach});
    if (!(begin < end)) return std::nullopt;
    const Vec3 p = line.at(0.5 * (begin + end));
    const double margin = std::max(1e-9 * magnitude(a, b, p), scene.contact_tolerance);
    if (end - begin <= margin) return std::nullopt;
    if (!is_well_inside(a, p, margin) || !is_well_inside(b, p, margin)) return std::nullopt;
    return p;
}

/// From where the line leaves one solid to where it enters the other.
std::optional<Gap> gap_between(const tracer::RenderScene& scene, const Part& left,
                               const Part& entered, const geom::Ray& line, const Inside& in_left,
                               const Inside& in_entered) {
    const double length = in_entered.begin - in_left.end;
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    const Vec3 p = line.at(in_left.end);
    const double scale = magnitude(left, entered, p);
    if (length > 1e3 * thin * scale) return std::nullopt;
    const Vec3 normal = left.shape.normal(in_left.last, p);
    const double width = length * std::abs(glm::dot(normal, line.direction));
    if (width > thin * scale || width <= tracer::tolerance(scene, 4.0 * scale)) return std::nullopt;
    return Gap{width, p};
}

}  // namespace

Meeting meet(const tracer::RenderScene& scene, const Part& a, const Part& b, int lines_per_axis) {
    Meeting meeting;
    const geom::Bounds box = common_region(scene, a, b, thin);
    if (box.is_empty()) return meeting;
    auto lines = sample_lines(box, lines_per_axis);
    const Vec3 way = b.shape.bounds().center() - a.shape.bounds().center();
    if (std::isfinite(glm::dot(way, way)) && glm::length(way) > 0.0) {
        geom::Ray line;
        line.origin = a.shape.bounds().center();
        line.direction = glm::normalize(way);
        lines.push_back(line);
    }
    for (const geom::Ray& line : lines) {
        const auto in_a = inside(a, line), in_b = inside(b, line);
        for (const Inside& i : in_a) {
            for (const Inside& j : in_b) {
                if (!meeting.shared) meeting.shared = shared_point(scene, a, b, line, i, j);
                if (const auto gap = gap_between(scene, a, b, line, i, j))
                    meeting.gaps.push_back(*gap);
                if (const auto gap = gap_between(scene, b, a, line, j, i))
                    meeting.gaps.push_back(*gap);
            }
        }
    }
    return meeting;
}

}  // namespace meniscus::inspect
