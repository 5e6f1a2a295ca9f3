#include "geom/torus.hpp"

#include <algorithm>
#include <array>

#include "geom/polynomial.hpp"

namespace meniscus::geom {

namespace {

/// A point relative to the ring: how far from the axis, and how far from the circle in the middle
/// of the tube.
struct RingPoint {
    double from_axis, from_circle;
    Vec3 out;  // away from the circle, `from_circle` long

    RingPoint(const Vec3& p, double major) : from_axis(glm::length(Vec2{p.x, p.z})) {
        const double scale = from_axis > 0.0 ? (from_axis - major) / from_axis : 0.0;
        out = {p.x * scale, p.y, p.z * scale};
        if (from_axis == 0.0) out.x = -major;
        from_circle = glm::length(out);
    }
};

/// A line with unit direction, seen from its point nearest to the torus' centre.
struct TorusLine {
    Vec3 e, d;
    double major, minor;

    struct Distance {
        double value, slope;  // from the surface, outwards; along the line
    };
    Distance distance(double t) const {
        const RingPoint p(e + t * d, major);
        return {p.from_circle - minor, glm::dot(p.out, d) / p.from_circle};
    }

    /// Where the distance, which changes its sign between the two, is 0: by Newton's method,
    /// halving where a step would leave the bracket.
    double root_between(double low, double high, bool rising) const {
        const double precision = unit_roundoff * (major + minor);
        double t = 0.5 * (low + high);
        for (int i = 0; i < 100; ++i) {
            const auto [value, slope] = distance(t);
            ((value < 0.0) == rising ? low : high) = t;
            double next = t - value / slope;
            if (!(next > low && next < high)) next = 0.5 * (low + high);
            const double step = glm::abs(next - t);
            t = next;
            if (step <= precision) break;
        }
        return t;
    }
};

}  // namespace

Bounds Torus::bounds() const {
    const Vec3 reach{major + minor, minor, major + minor};
    return {-reach, reach};
}

void Torus::crossings(const Ray& ray, Crossings& out) const {
    // Seen from the point of the line nearest to the centre, with a unit direction, the quartic has
    // no cubic term and its roots are no larger than the torus.
    const double length = glm::length(ray.direction);
    const Vec3 d = ray.direction / length;
    const Vec3 from_center = ray.from(Vec3{0.0});
    const double shift = -glm::dot(from_center, d);
    const TorusLine line{from_center + shift * d, d, major, minor};
    const Vec3& e = line.e;
    const double reach = major + minor, ee = glm::dot(e, e);
    if (!(ee < reach * reach)) return;
    const double half_chord = glm::sqrt((reach * reach - ee)) * (1.0 + 1e-9) + 1e-9 * reach;

    // (p.p + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) is the product of two differences, of squares of the
    // distances from the near and the far side of the ring and r^2. Only its extremes are taken
    // from it: they part the line into stretches with one crossing at most. Which of them have one,
    // and where, is asked of the distance itself, which keeps its digits where the quartic does
    // not.
    const double k = ee + (major - minor) * (major + minor), four_r2 = 4.0 * major * major;
    const double dd = d.x * d.x + d.z * d.z, ed = e.x * d.x + e.z * d.z;
    const std::array<double, 4> slope{-2.0 * four_r2 * ed, 2.0 * (2.0 * k - four_r2 * dd), 0.0,
                                      4.0};
    Roots stops = roots_between(slope, -half_chord, half_chord);
    if (minor > major && dd > 0.0) {
        // Here the skin has a dimple, and the distance an extreme of its own next to the axis.
        stops.push_back(glm::clamp(-ed / dd, -half_chord, half_chord));
        std::sort(stops.begin(), stops.end());
    }
    stops.push_back(half_chord);

    double left = -half_chord;
    bool was_inside = false;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const double right = stops[i];
        const bool is_inside = i + 1 < stops.size() && line.distance(right).value < 0.0;
        if (is_inside != was_inside) {
            const double t = line.root_between(left, right, was_inside);
            out.push_back({(shift + t) / length, 0, is_inside});
        }
        left = right;
        was_inside = is_inside;
    }
}

bool Torus::contains(const Vec3& p) const { return RingPoint(p, major).from_circle < minor; }

Vec3 Torus::normal(Face, const Vec3& p) const {
    const RingPoint q(p, major);
    return q.from_circle > 0.0 ? q.out / q.from_circle : Vec3{0.0, 1.0, 0.0};
}

Vec3 Torus::to_face(Face face, const Ray& point) const {
    const Vec3 p = point.from(Vec3{0.0});
    return normal(face, p) * (minor - RingPoint(p, major).from_circle);
}

}  // namespace meniscus::geom
