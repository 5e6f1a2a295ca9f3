#include "geom/torus.hpp"

#include <array>

#include "geom/alternate.hpp"
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
    const Vec3 e = from_center + shift * d;
    const double reach = major + minor, ee = glm::dot(e, e);
    if (!(ee < reach * reach)) return;
    const double half_chord = glm::sqrt((reach * reach - ee)) * (1.0 + 1e-9) + 1e-9 * reach;

    // (p.p + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2)
    const double k = ee + (major - minor) * (major + minor), four_r2 = 4.0 * major * major;
    const std::array<double, 5> quartic{k * k - four_r2 * (e.x * e.x + e.z * e.z),
                                        -2.0 * four_r2 * (e.x * d.x + e.z * d.z),
                                        2.0 * k - four_r2 * (d.x * d.x + d.z * d.z), 0.0, 1.0};
    const Roots roots = roots_between(quartic, -half_chord, half_chord);

    Candidates candidates;
    // A last step by the distance from the surface, which is accurate where the quartic is not.
    const auto keep = [&](double t, double limit) {
        const RingPoint p(e + t * d, major);
        const double slope = glm::dot(p.out, d) / p.from_circle;
        const double step = (p.from_circle - minor) / slope;
        if (glm::abs(step) <= limit) t -= step;
        candidates.push_back({(shift + t) / length, 0});
    };
    for (std::size_t i = 0; i < roots.size(); ++i) {
        double limit = 1e-3 * minor;  // and not as far as half-way to the neighbours
        if (i > 0) limit = glm::min(limit, 0.4 * (roots[i] - roots[i - 1]));
        if (i + 1 < roots.size()) limit = glm::min(limit, 0.4 * (roots[i + 1] - roots[i]));
        keep(roots[i], limit);
    }
    if (minor > major && d.y != 0.0) {
        // On the axis the quartic only touches 0, for there the inner skin meets the outer one.
        const double height = glm::sqrt((minor - major) * (minor + major));
        for (const double y : {height, -height}) keep((y - e.y) / d.y, 1e-3 * minor);
    }
    const auto inside = [&](double t) { return contains(e + (t * length - shift) * d); };
    keep_changes(candidates, 0.0, inside, out);
}

bool Torus::contains(const Vec3& p) const { return RingPoint(p, major).from_circle < minor; }

Vec3 Torus::normal(Face, const Vec3& p) const {
    const RingPoint q(p, major);
    return q.from_circle > 0.0 ? q.out / q.from_circle : Vec3{0.0, 1.0, 0.0};
}

Vec3 Torus::on_face(Face face, const Vec3& p) const {
    return p + normal(face, p) * (minor - RingPoint(p, major).from_circle);
}

}  // namespace meniscus::geom
