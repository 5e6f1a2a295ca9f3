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

/// Nearer than this to a surface is touching it.
double margin(const tracer::RenderScene& scene, const Part& a, const Part& b, const Vec3& p) {
    return tracer::tolerance(scene, 8.0 * magnitude(a, b, p));
}

/// A stretch of a line that both solids share, if there is enough of it.
struct Shared {
    Vec3 middle;
    double length;
};
std::optional<Shared> shared_stretch(const tracer::RenderScene& scene, const Part& a, const Part& b,
                                     const geom::Ray& line, const Inside& in_a,
                                     const Inside& in_b) {
    const double reach = 2.0 * scene.size;  // of endless stretches
    const double begin = std::max({in_a.begin, in_b.begin, -reach});
    const double end = std::min({in_a.end, in_b.end, reach});
    if (!(begin < end)) return std::nullopt;
    const Vec3 p = line.at(0.5 * (begin + end));
    if (end - begin <= margin(scene, a, b, p)) return std::nullopt;
    return Shared{p, end - begin};
}

/// How far both solids go on together to either side of `p`.
double thickness(const Part& a, const Part& b, const Vec3& p, const Vec3& direction) {
    geom::Ray line;
    line.origin = p;
    line.direction = direction;
    double begin = -geom::infinity, end = geom::infinity;
    for (const Part* part : {&a, &b}) {
        for (const Inside& stretch : inside(*part, line)) {
            if (stretch.begin > 0.0 || stretch.end < 0.0) continue;
            begin = std::max(begin, stretch.begin);
            end = std::min(end, stretch.end);
        }
    }
    return end - begin;
}

double thickness(const Part& a, const Part& b, const Vec3& p, const std::optional<Vec3>& way) {
    double least = way ? thickness(a, b, p, *way) : geom::infinity;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction{0.0};
        direction[axis] = 1.0;
        least = std::min(least, thickness(a, b, p, direction));
    }
    return least;
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

/// Where the solid of lower priority goes on beyond an end of the other: a film of it.
std::optional<Gap> film_beyond(const tracer::RenderScene& scene, const Part& low, const Part& high,
                               const geom::Ray& line, double low_end, double high_end,
                               geom::Face face) {
    const double length = std::abs(low_end - high_end);
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    const Vec3 p = line.at(high_end);
    const double scale = magnitude(low, high, p);
    if (length > 1e3 * thin * scale) return std::nullopt;
    const double width = length * std::abs(glm::dot(high.shape.normal(face, p), line.direction));
    if (width > thin * scale || width <= tracer::tolerance(scene, 4.0 * scale)) return std::nullopt;
    return Gap{width, p};
}

void add_films(const tracer::RenderScene& scene, const Part& low, const Part& high,
               const geom::Ray& line, const Inside& in_low, const Inside& in_high,
               std::vector<Gap>& films) {
    const bool share = std::max(in_low.begin, in_high.begin) < std::min(in_low.end, in_high.end);
    if (!share || !(low.priority < high.priority)) return;
    const auto add = [&](const std::optional<Gap>& film) {
        if (film) films.push_back(*film);
    };
    if (in_low.end > in_high.end)
        add(film_beyond(scene, low, high, line, in_low.end, in_high.end, in_high.last));
    if (in_low.begin < in_high.begin)
        add(film_beyond(scene, low, high, line, in_low.begin, in_high.begin, in_high.first));
}

}  // namespace

Meeting meet(const tracer::RenderScene& scene, const Part& a, const Part& b, int lines_per_axis) {
    Meeting meeting;
    const geom::Bounds box = common_region(scene, a, b, thin);
    if (box.is_empty()) return meeting;
    auto lines = sample_lines(box, lines_per_axis);
    const Vec3 from_a_to_b = b.shape.bounds().center() - a.shape.bounds().center();
    std::optional<Vec3> way;
    if (std::isfinite(glm::dot(from_a_to_b, from_a_to_b)) && glm::length(from_a_to_b) > 0.0) {
        way = glm::normalize(from_a_to_b);
        geom::Ray line;
        line.origin = a.shape.bounds().center();
        line.direction = *way;
        lines.push_back(line);
    }
    std::optional<Shared> deepest;
    for (const geom::Ray& line : lines) {
        const auto in_a = inside(a, line), in_b = inside(b, line);
        for (const Inside& i : in_a) {
            for (const Inside& j : in_b) {
                const auto shared = shared_stretch(scene, a, b, line, i, j);
                if (shared && (!deepest || shared->length > deepest->length)) {
                    const double least = margin(scene, a, b, shared->middle);
                    if (is_well_inside(a, shared->middle, least) &&
                        is_well_inside(b, shared->middle, least))
                        deepest = shared;
                }
                if (const auto gap = gap_between(scene, a, b, line, i, j))
                    meeting.gaps.push_back(*gap);
                if (const auto gap = gap_between(scene, b, a, line, j, i))
                    meeting.gaps.push_back(*gap);
                add_films(scene, a, b, line, i, j, meeting.films);
                add_films(scene, b, a, line, j, i, meeting.films);
            }
        }
    }
    if (deepest) meeting.overlap = {deepest->middle, thickness(a, b, deepest->middle, way)};
    return meeting;
}

}  // namespace meniscus::inspect
