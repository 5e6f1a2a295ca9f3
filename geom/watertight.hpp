#pragma once

#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "geom/ray.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

/// The sign of p.x q.y - p.y q.x: on which side of the edge from p to q the z axis passes. Zero
/// only if p.xy = q.xy.
[[gnu::always_inline]] inline int edge_sign(const Vec3& p, const Vec3& q) {
    const double a = p.x * q.y, b = p.y * q.x;
    // Rounding keeps the order, so unequal products are in the right one.
    if (a != b) return a > b ? 1 : -1;
    const double rest_a = std::fma(p.x, q.y, -a), rest_b = std::fma(p.y, q.x, -b);
    if (rest_a != rest_b) return rest_a > rest_b ? 1 : -1;
    // The axis meets the edge: decide as if it were moved by (e, e^2) with e infinitely small.
    if (p.y != q.y) return p.y > q.y ? 1 : -1;
    if (p.x != q.x) return q.x > p.x ? 1 : -1;
    return 0;
}

/// The value that has that sign, to two unit roundoffs of itself (Kahan's difference of products):
/// slivers, whose three are small differences, keep all digits.
[[gnu::always_inline]] inline double edge_function(const Vec3& p, const Vec3& q) {
    const double product = p.y * q.x;
    return std::fma(p.x, q.y, -product) - std::fma(p.y, q.x, -product);
}

/// A line prepared for triangles: a shear makes it the z axis (Woop, Benthin and Wald 2013). A
/// vertex looks the same from every triangle that uses it, and the sign of an edge is exact for
/// what the shear gave; so neighbours never disagree about a line near their common edge, and a
/// closed mesh is entered as often as it is left.
class TriangleLine {
public:
    explicit TriangleLine(const Ray& ray);

    struct Hit {
        double t;
        bool entering;  // the line runs against cross(b - a, c - a)
    };
    /// Always inlined, so that an fma is one instruction where the caller's processor has it.
    std::optional<Hit> hit(const Vec3& a, const Vec3& b, const Vec3& c) const;

    // For whoever shears by himself.
    const Ray& ray() const { return ray_; }
    std::array<int, 3> axes() const { return {x_, y_, z_}; }
    /// x and y move by so much for each unit along z.
    const Vec3& shear() const { return shear_; }

private:
    Vec3 sheared(const Vec3& vertex) const;

    Ray ray_;
    int x_, y_, z_;  // the axes, permuted so that the direction is longest along z_
    Vec3 shear_;
    bool backwards_;  // against the axis z_
};

inline TriangleLine::TriangleLine(const Ray& ray) : ray_(ray) {
    const Vec3 size = glm::abs(ray.direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = z_ == 2 ? 0 : z_ + 1;
    y_ = z_ == 0 ? 2 : z_ - 1;
    const double* const d = glm::value_ptr(ray_.direction);
    backwards_ = d[z_] < 0.0;
    shear_ = {d[x_] / d[z_], d[y_] / d[z_], 1.0 / d[z_]};
}

[[gnu::always_inline]] inline Vec3 TriangleLine::sheared(const Vec3& vertex) const {
    const Vec3 way = -ray_.from(vertex);
    const double* const e = glm::value_ptr(way);  // by address: axes are hard to guess
    return {e[x_] - shear_.x * e[z_], e[y_] - shear_.y * e[z_], shear_.z * e[z_]};
}

[[gnu::always_inline]] inline std::optional<TriangleLine::Hit> TriangleLine::hit(
    const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Vec3 p = sheared(a), q = sheared(b), r = sheared(c);
    const int sign = edge_sign(p, q);
    if (sign == 0 || edge_sign(q, r) != sign || edge_sign(r, p) != sign) return std::nullopt;
    const double u = edge_function(q, r), v = edge_function(r, p), w = edge_function(p, q);
    const double sum = u + v + w;
    double t = sum != 0.0 ? (u * p.z + v * q.z + w * r.z) / sum : (p.z + q.z + r.z) / 3.0;
    // Where all but the signs is lost to rounding, stay with the triangle.
    t = glm::clamp(t, glm::min(p.z, glm::min(q.z, r.z)), glm::max(p.z, glm::max(q.z, r.z)));
    return Hit{t, (sign < 0) != backwards_};
}

}  // namespace meniscus::geom
