#include "tests/geom/error_census.hpp"

#include <algorithm>

namespace meniscus::geom {

namespace {

struct Break {
    Quad t;
    Face face;
    bool is_exact;
};

Crossings computed_crossings(const PlacedShape& shape, const Ray& ray, Face pin) {
    Crossings found;
    if (pin == no_face) {
        shape.crossings(ray, found);
        return found;
    }
    const Interval span = shape.interval(ray, pin);
    if (!span.hit) return found;
    if (span.t0 > -infinity) found.push_back({span.t0, span.face0, true});
    if (span.t1 < infinity) found.push_back({span.t1, span.face1, false});
    return found;
}

/// How far a place on the line is from the nearest one on the other side of the surface, in units:
/// 1, 2, 4, ... or infinite, looking along the normal of `face`, the axes and the
/// diagonals.
double depth_in_units(const Referee& referee, const Ray& ray, Quad t, Face face, double unit) {
    const QuadVec p = Referee::at(ray, t);
    const bool inside = referee.contains(p);
    const QuadVec ways[] = {referee.normal(ray, face, t),
                            {1, 0, 0},
                            {0, 1, 0},
                            {0, 0, 1},
                            {1, 1, 1},
                            {1, 1, -1},
                            {1, -1, 1},
                            {-1, 1, 1}};
    for (double units = 1.0; units < 0x1p53; units *= 2.0) {
        for (const QuadVec& way : ways) {
            const QuadVec step = Quad(units * unit) * way;
            if (referee.contains(p + step) != inside || referee.contains(p - step) != inside) {
                return units;
            }
        }
    }
    return infinity;
}

}  // namespace

double error_in_units(const PlacedShape& shape, const Referee& referee, const Ray& ray, Face pin) {
    std::vector<Break> breaks;
    for (const Crossing& c : computed_crossings(shape, ray, pin)) {
        breaks.push_back({Quad(c.t), c.face, false});
    }
    for (const auto& c : referee.crossings(ray)) breaks.push_back({c.t, c.face, true});
    std::sort(breaks.begin(), breaks.end(), [](auto& a, auto& b) { return a.t < b.t; });

    double worst = 0.0;
    bool computed = false, exact = false;
    for (std::size_t i = 0; i < breaks.size(); ++i) {
        (breaks[i].is_exact ? exact : computed) ^= true;
        if (computed == exact) continue;
        if (i + 1 == breaks.size()) {
            // Only a half-space can have an odd number: missed by a line that is parallel but for
            // rounding.
            worst =
                std::max(worst, referee.cosine(ray, breaks[i].face, breaks[i].t) / unit_roundoff);
            break;
        }
        const Break &a = breaks[i], &b = breaks[i + 1];
        const double length = double(Quad(b.t - a.t));
        const double reach = std::max(std::abs(double(a.t)), std::abs(double(b.t)));
        const double unit = unit_roundoff * (max_abs(ray.origin) + reach + shape.magnitude());
        if (length <= 1e-3 * worst * unit) continue;
        const double slope =
            std::min(referee.cosine(ray, a.face, a.t), referee.cosine(ray, b.face, b.t));
        double error = length * slope / unit;
        // Lines within a face, along an edge, through a corner: the piece is no longer thin, but
        // all of it is on the surface.
        if (error > 8.0) {
            const Quad middle = (a.t + b.t) / 2;
            error = std::min(error, std::max(depth_in_units(referee, ray, middle, a.face, unit),
                                             depth_in_units(referee, ray, middle, b.face, unit)));
        }
        worst = std::max(worst, error);
    }
    return worst;
}

Census census(Kind kind, Placement placement, int count, unsigned seed) {
    Dice dice(seed);
    Census result;
    while (result.lines < count) {
        const Shape unplaced = random_shape(kind, dice);
        const Bounds local = finite_bounds(unplaced);
        const double size = max_abs(local.size());
        const Transform transform = random_transform(placement, size, dice);
        const PlacedShape shape(unplaced, transform);
        const Referee referee(unplaced, transform);
        const auto judge = [&](const Ray& ray, Face pin) {
            const double error = error_in_units(shape, referee, ray, pin);
            ++result.lines;
            if (!(error <= result.worst)) {
                result.worst = error;
                result.ray = ray;
                result.shape = unplaced;
                result.transform = transform;
            }
        };
        for (int i = 0; i < 20; ++i) {
            const double distance = size * log_uniform(-2.0, i % 4 == 0 ? 6.0 : 1.0, dice);
            Vec3 d = dice.direction();
            const Vec3 target = random_target(local, transform, dice);
            if (i % 3 == 0) {  // along an axis, an edge or a diagonal of the bounds
                const Vec3 way = random_target(local, transform, dice) - target;
                if (glm::length(way) > 0.0) d = glm::normalize(way);
            }
            const Ray ray{target - distance * d, d};
            judge(ray, no_face);

            Crossings found;
            shape.crossings(ray, found);
            if (found.empty()) continue;
            result.crossings += static_cast<int>(found.size());
            const Crossing& crossing = found[std::size_t(dice.below(int(found.size())))];
            const Vec3 p = shape.on_face(crossing.face, ray.at(crossing.t));
            const Vec3 grazing = direction_at(shape.normal(crossing.face, p), dice);
            judge({p - distance * grazing, grazing}, no_face);
            if (shape.is_convex()) judge({p, grazing}, crossing.face);
        }
    }
    return result;
}

}  // namespace meniscus::geom
