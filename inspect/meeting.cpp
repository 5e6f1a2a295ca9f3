#include "inspect/meeting.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

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

/// What third solids of higher priority leave of a stretch: the longest piece.
std::pair<double, double> longest_uncovered(std::pair<double, double> stretch,
                                            const geom::Ray& line,
                                            std::span<const Part* const> covers) {
    std::vector<std::pair<double, double>> covered;
    for (const Part* part : covers) {
        for (const Inside& within : inside(*part, line))
            covered.emplace_back(within.begin, within.end);
    }
    std::ranges::sort(covered);
    double begin = stretch.first;
    const double end = stretch.second;
    std::pair<double, double> longest{begin, begin};
    const auto leave = [&](double until) {
        if (until - begin > longest.second - longest.first) longest = {begin, until};
    };
    for (const auto& [from, to] : covered) {
        leave(std::min(from, end));
        begin = std::max(begin, to);
    }
    leave(end);
    return longest;
}

/// A stretch of a line that both solids share, if there is enough of it.
struct Shared {
    Vec3 middle;
    double length;
};
std::optional<Shared> shared_stretch(const tracer::RenderScene& scene, const Part& a, const Part& b,
                                     const geom::Ray& line, const Inside& in_a, const Inside& in_b,
                                     std::span<const Part* const> covers) {
    const double reach = 2.0 * scene.size;  // of endless stretches
    double begin = std::max({in_a.begin, in_b.begin, -reach});
    double end = std::min({in_a.end, in_b.end, reach});
    if (!(begin < end)) return std::nullopt;
    std::tie(begin, end) = longest_uncovered({begin, end}, line, covers);
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

/// Whether another part fills a point between two: of a solid of higher priority than `priority`,
/// or of one of the two solids, if that is a union.
bool is_covered(const tracer::RenderScene& scene, const Part& a, const Part& b, const Vec3& p,
                double priority) {
    bool covered = false;
    const auto look = [&](int index) {
        const Part& part = scene.parts[std::size_t(index)];
        if (!part.is_member || &part == &a || &part == &b) return;
        const bool is_own = part.solid == a.solid || part.solid == b.solid;
        covered |= (is_own || part.priority > priority) && part.shape.contains(p) != part.inverse;
    };
    for (const int index : scene.unbounded) look(index);
    scene.bvh.overlapping({p, p},
                          [&](std::uint32_t primitive) { look(scene.bvh_parts[primitive]); });
    return covered;
}

/// Third solids that win over both of two of one priority in a region. (Over others the stronger of
/// the two wins anyway.)
std::vector<const Part*> solids_above(const tracer::RenderScene& scene, const Part& a,
                                      const Part& b, const geom::Bounds& box) {
    std::vector<const Part*> result;
    if (a.priority != b.priority) return result;
    const auto look = [&](int index) {
        const Part& part = scene.parts[std::size_t(index)];
        if (part.is_member && part.priority > a.priority) result.push_back(&part);
    };
    for (const int index : scene.unbounded) look(index);
    scene.bvh.overlapping(box, [&](std::uint32_t primitive) { look(scene.bvh_parts[primitive]); });
    return result;
}

/// What slits count, along the normal.
struct Widths {
    double widest = 0.0;  // scene units, whatever tolerance the scene states; 0: by `thin`

    /// Farther along a line none is looked for.
    double reach(double magnitude) const {
        return widest > 0.0 ? 100.0 * widest : 1e3 * thin * magnitude;
    }
    bool contain(const tracer::RenderScene& scene, double width, double magnitude) const {
        if (widest > 0.0) {
            const double rounding = scene.tolerance_units * geom::unit_roundoff * 4.0 * magnitude;
            return width <= widest && width > rounding;
        }
        return is_thin(scene, width, magnitude);
    }
};

/// The slit on the line from a face of `part` to one of `other`, if it is too thin to be meant, too
/// wide for rounding, and filled by no third solid above `priority`.
std::optional<Gap> slit(const tracer::RenderScene& scene, const geom::Ray& line, const Part& part,
                        geom::Face face, double t, const Part& other, double t_other,
                        double priority, const Widths& widths) {
    const double length = std::abs(t_other - t);
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    const Vec3 p = line.at(t);
    const double scale = magnitude(part, other, p);
    if (length > widths.reach(scale)) return std::nullopt;
    const double width = length * std::abs(glm::dot(part.shape.normal(face, p), line.direction));
    if (!widths.contain(scene, width, scale)) return std::nullopt;
    const Vec3 middle = line.at(0.5 * (t + t_other));
    if (is_covered(scene, part, other, middle, priority)) return std::nullopt;
    return Gap{width, middle};
}

/// From where the line leaves one solid to where it enters the other.
void add_gap(const tracer::RenderScene& scene, const geom::Ray& line, const Part& left,
             const Inside& in_left, const Part& entered, const Inside& in_entered,
             const Widths& widths, std::vector<Gap>& gaps) {
    if (!(in_left.end < in_entered.begin)) return;
    const auto gap = slit(scene, line, left, in_left.last, in_left.end, entered, in_entered.begin,
                          std::min(left.priority, entered.priority), widths);
    if (gap) gaps.push_back(*gap);
}

/// Where the solid of lower priority goes on beyond an end of the other: films of it.
void add_films(const tracer::RenderScene& scene, const geom::Ray& line, const Part& low,
               const Inside& in_low, const Part& high, const Inside& in_high, const Widths& widths,
               std::vector<Gap>& films) {
    const bool share = std::max(in_low.begin, in_high.begin) < std::min(in_low.end, in_high.end);
    if (!share || !(low.priority < high.priority)) return;
    const auto add = [&](geom::Face face, double t, double t_low) {
        if (const auto film = slit(scene, line, high, face, t, low, t_low, low.priority, widths))
            films.push_back(*film);
    };
    if (in_low.end > in_high.end) add(in_high.last, in_high.end, in_low.end);
    if (in_low.begin < in_high.begin) add(in_high.first, in_high.begin, in_low.begin);
}

Meeting meet(const tracer::RenderScene& scene, const Part& a, const Part& b,
             const geom::Bounds& box, int lines_per_axis, const Widths& widths) {
    Meeting meeting;
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
    const std::vector<const Part*> covers = solids_above(scene, a, b, box);
    std::optional<Shared> deepest;
    for (const geom::Ray& line : lines) {
        const auto in_a = inside(a, line), in_b = inside(b, line);
        for (const Inside& i : in_a) {
            for (const Inside& j : in_b) {
                const auto shared = shared_stretch(scene, a, b, line, i, j, covers);
                if (shared && (!deepest || shared->length > deepest->length)) {
                    const double least = margin(scene, a, b, shared->middle);
                    if (is_well_inside(a, shared->middle, least) &&
                        is_well_inside(b, shared->middle, least))
                        deepest = shared;
                }
                add_gap(scene, line, a, i, b, j, widths, meeting.gaps);
                add_gap(scene, line, b, j, a, i, widths, meeting.gaps);
                add_films(scene, line, a, i, b, j, widths, meeting.films);
                add_films(scene, line, b, j, a, i, widths, meeting.films);
            }
        }
    }
    if (deepest) meeting.overlap = {deepest->middle, thickness(a, b, deepest->middle, way)};
    return meeting;
}

}  // namespace

bool is_thin(const tracer::RenderScene& scene, double width, double magnitude) {
    return width <= thin * magnitude && width > tracer::tolerance(scene, 4.0 * magnitude);
}

Meeting meet(const tracer::RenderScene& scene, const Part& a, const Part& b, int lines_per_axis) {
    return meet(scene, a, b, common_region(scene, a, b, thin), lines_per_axis, {});
}

Meeting meet_within(const tracer::RenderScene& scene, const Part& a, const Part& b,
                    int lines_per_axis, double widest) {
    const auto box = common_region(scene, a, b, 0.0).padded(widest);
    return meet(scene, a, b, box, lines_per_axis, {widest});
}

}  // namespace meniscus::inspect
