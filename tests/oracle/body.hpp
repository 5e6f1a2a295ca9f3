#pragma once

#include <stdexcept>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/object.hpp"
#include "tests/oracle/mesh_body.hpp"
#include "tests/oracle/real.hpp"
#include "tests/oracle/roots.hpp"
#include "tests/oracle/turned_body.hpp"

namespace meniscus::oracle {

/// One object of a scene, as two independent questions: where does a line meet any of the surfaces
/// that its shape is cut from (whole planes, whole cylinders: more than its boundary), and does it
/// contain a point. Which of the meetings are real is left to the second question.
template <class Real>
class Body {
public:
    using V = Vector<Real>;

    explicit Body(const scene::Object& object)
        : shape_(prepared(object.shape)), inverse_(object.inverse) {
        const auto& m = object.transform.linear();  // m[column][row]
        const V a = widen<Real>(m[0]), b = widen<Real>(m[1]), c = widen<Real>(m[2]);
        const Real determinant = dot(a, cross(b, c));
        rows_[0] = (Real(1) / determinant) * cross(b, c);
        rows_[1] = (Real(1) / determinant) * cross(c, a);
        rows_[2] = (Real(1) / determinant) * cross(a, b);
        shift_ = widen<Real>(object.transform.shift());
    }

    V to_local_vector(const V& v) const {
        return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)};
    }
    V to_local(const V& p) const { return to_local_vector(p - shift_); }

    bool contains(const V& p) const {
        const V q = to_local(p);
        return std::visit([&](const auto& s) { return inside(s, q); }, shape_) != inverse_;
    }

    /// Calls emit(t, face) for each meeting of the whole line o + t d.
    template <class Emit>
    void meet(const V& o, const V& d, Emit emit) const {
        const V e = to_local(o), f = to_local_vector(d);
        std::visit([&](const auto& s) { meetings(s, e, f, emit); }, shape_);
    }

    /// A unit normal of the face at p; it points out of the object.
    V normal(int face, const V& p) const {
        const V q = to_local(p);
        const V n = std::visit([&](const auto& s) { return gradient(s, face, q); }, shape_);
        const V world = unit(n.x * rows_[0] + n.y * rows_[1] + n.z * rows_[2]);
        return inverse_ ? -world : world;
    }

private:
    /// The shapes that the oracle knows.
    using Shape = std::variant<geom::Sphere, geom::Box, geom::Plane, geom::Cylinder, geom::Cone,
                               geom::Torus, TurnedBody<Real>, MeshBody<Real>>;

    static Shape prepared(const geom::Shape& shape) {
        if (!geom::is_closed(shape))
            throw std::invalid_argument("the oracle knows closed shapes only");
        return std::visit(
            [](const auto& s) -> Shape {
                using Given = std::decay_t<decltype(s)>;
                if constexpr (std::is_same_v<Given, geom::Lathe>) {
                    return TurnedBody<Real>(s);
                } else if constexpr (std::is_same_v<Given, geom::Mesh>) {
                    return MeshBody<Real>(s);
                } else if constexpr (std::is_constructible_v<Shape, Given>) {
                    return s;
                } else {
                    throw std::invalid_argument("the oracle does not know this shape");
                }
            },
            shape);
    }

    // Sphere
    static bool inside(const geom::Sphere& s, const V& p) {
        const V e = p - widen<Real>(s.center);
        return dot(e, e) < Real(s.radius) * Real(s.radius);
    }
    template <class Emit>
    static void meetings(const geom::Sphere& s, const V& o, const V& d, Emit emit) {
        around(o - widen<Real>(s.center), d, Real(s.radius), 0, emit);
    }
    static V gradient(const geom::Sphere& s, int, const V& p) { return p - widen<Real>(s.center); }

    // Box: faces 0 to 5 are low x, high x, low y, ...
    static bool inside(const geom::Box& s, const V& p) {
        const auto between = [](double a, double b, Real x) {
            return Real(a < b ? a : b) < x && x < Real(a < b ? b : a);
        };
        return between(s.corner1.x, s.corner2.x, p.x) && between(s.corner1.y, s.corner2.y, p.y) &&
               between(s.corner1.z, s.corner2.z, p.z);
    }
    template <class Emit>
    static void meetings(const geom::Box& s, const V& o, const V& d, Emit emit) {
        const auto pair = [&](double a, double b, Real from, Real along, int face) {
            if (along == 0) return;
            emit((Real(a < b ? a : b) - from) / along, face);
            emit((Real(a < b ? b : a) - from) / along, face + 1);
        };
        pair(s.corner1.x, s.corner2.x, o.x, d.x, 0);
        pair(s.corner1.y, s.corner2.y, o.y, d.y, 2);
        pair(s.corner1.z, s.corner2.z, o.z, d.z, 4);
    }
    static V gradient(const geom::Box&, int face, const V&) {
        const Real sign = face % 2 == 0 ? -1 : 1;
        return {face / 2 == 0 ? sign : Real(0), face / 2 == 1 ? sign : Real(0),
                face / 2 == 2 ? sign : Real(0)};
    }

    // Half-space
    static V unit_normal(const geom::Plane& s) { return unit(widen<Real>(s.direction)); }
    static bool inside(const geom::Plane& s, const V& p) {
        return dot(unit_normal(s), p) < Real(s.distance);
    }
    template <class Emit>
    static void meetings(const geom::Plane& s, const V& o, const V& d, Emit emit) {
        flat(unit_normal(s), Real(s.distance), o, d, 0, emit);
    }
    static V gradient(const geom::Plane& s, int, const V&) { return unit_normal(s); }

    // Cylinder: face 0 is the side, 1 the base, 2 the cap
    static bool inside(const geom::Cylinder& s, const V& p) {
        const V w = widen<Real>(s.cap) - widen<Real>(s.base), e = p - widen<Real>(s.base);
        const Real along = dot(e, w), whole = dot(w, w);
        const V away = e - (along / whole) * w;
        return 0 < along && along < whole && dot(away, away) < Real(s.radius) * Real(s.radius);
    }
    template <class Emit>
    static void meetings(const geom::Cylinder& s, const V& o, const V& d, Emit emit) {
        const V w = widen<Real>(s.cap) - widen<Real>(s.base), e = o - widen<Real>(s.base);
        const Real whole = dot(w, w);
        around(e - (dot(e, w) / whole) * w, d - (dot(d, w) / whole) * w, Real(s.radius), 0, emit);
        flat(w, Real(0), e, d, 1, emit);
        flat(w, whole, e, d, 2, emit);
    }
    static V gradient(const geom::Cylinder& s, int face, const V& p) {
        const V w = widen<Real>(s.cap) - widen<Real>(s.base), e = p - widen<Real>(s.base);
        if (face != 0) return face == 1 ? -w : w;
        return e - (dot(e, w) / dot(w, w)) * w;
    }

    // Cone: the same faces. The radius is base_radius + slope * s, s from 0 to 1 along the axis.
    static bool inside(const geom::Cone& s, const V& p) {
        const V w = widen<Real>(s.cap) - widen<Real>(s.base), e = p - widen<Real>(s.base);
        const Real along = dot(e, w) / dot(w, w);
        const V away = e - along * w;
        const Real radius =
            Real(s.base_radius) + (Real(s.cap_radius) - Real(s.base_radius)) * along;
        return 0 < along && along < 1 && dot(away, away) < radius * radius;
    }
    template <class Emit>
    static void meetings(const geom::Cone& s, const V& o, const V& d, Emit emit) {
        const V w = widen<Real>(s.cap) - widen<Real>(s.base), e = o - widen<Real>(s.base);
        const Real whole = dot(w, w), slope = Real(s.cap_radius) - Real(s.base_radius);
        const Real at = dot(e, w) / whole, rate = dot(d, w) / whole;
        const V ep = e - at * w, dp = d - rate * w;
        const Real radius = Real(s.base_radius) + slope * at, growth = slope * rate;
        const Real a = dot(dp, dp) - growth * growth, b = dot(ep, dp) - radius * growth,
                   c = dot(ep, ep) - radius * radius;
        const Real discriminant = b * b - a * c;
        if (discriminant >= 0) {
            const Real root = square_root(discriminant), q = b < 0 ? -b + root : -b - root;
            if (a != 0) emit(q / a, 0);
            if (q != 0) emit(c / q, 0);
        }
        flat(w, Real(0), e, d, 1, emit);
        flat(w, whole, e, d, 2, emit);
    }
    static V gradient(const geom::Cone& s, int face, const V& p) {
        const V w = widen<Real>(s.cap) - widen<Real>(s.base), e = p - widen<Real>(s.base);
        if (face != 0) return face == 1 ? -w : w;
        const Real whole = dot(w, w), along = dot(e, w) / whole;
        const Real slope = Real(s.cap_radius) - Real(s.base_radius);
        const Real radius = Real(s.base_radius) + slope * along;
        return e - along * w - (radius * slope / whole) * w;
    }

    // Torus about the y axis
    static bool inside(const geom::Torus& s, const V& p) {
        const Real ring = square_root(p.x * p.x + p.z * p.z) - Real(s.major);
        return ring * ring + p.y * p.y < Real(s.minor) * Real(s.minor);
    }
    template <class Emit>
    static void meetings(const geom::Torus& s, const V& o, const V& d, Emit emit) {
        const Real major = s.major, minor = s.minor, reach = major + minor;
        const Real dd = dot(d, d), nearest = -dot(o, d) / dd;
        const V p = o + nearest * d;  // all coefficients are small from here
        const Real pp = dot(p, p);
        if (pp > reach * reach) return;
        // (|p + t d|^2 + R^2 - r^2)^2 = 4 R^2 (|p + t d|^2 - (p + t d)_y^2), p.d = 0
        const Real k = pp + major * major - minor * minor, four = 4 * major * major;
        const std::vector<Real> quartic{k * k - four * (pp - p.y * p.y), four * 2 * p.y * d.y,
                                        2 * k * dd - four * (dd - d.y * d.y), Real(0), dd * dd};
        const Real half = square_root(Real((reach * reach - pp) / dd)) * Real(1.01) + Real(1e-3);
        for (const Real t : real_roots(quartic, -half, half)) emit(nearest + t, 0);
    }
    static V gradient(const geom::Torus& s, int, const V& p) {
        const Real ring = square_root(p.x * p.x + p.z * p.z);
        const Real scale = Real(1) - Real(s.major) / ring;
        return {p.x * scale, p.y, p.z * scale};
    }

    // Lathe and mesh
    template <class Prepared>
    static bool inside(const Prepared& s, const V& p) {
        return s.inside(p);
    }
    template <class Prepared, class Emit>
    static void meetings(const Prepared& s, const V& o, const V& d, Emit emit) {
        s.meetings(o, d, emit);
    }
    template <class Prepared>
    static V gradient(const Prepared& s, int face, const V& p) {
        return s.gradient(face, p);
    }

    /// |e + t d| = r
    template <class Emit>
    static void around(const V& e, const V& d, Real r, int face, Emit emit) {
        const Real dd = dot(d, d);
        if (dd == 0) return;
        const Real middle = -dot(e, d) / dd;
        const V nearest = e + middle * d;
        const Real left = r * r - dot(nearest, nearest);
        if (left < 0) return;
        const Real half = square_root(Real(left / dd));
        emit(middle - half, face);
        emit(middle + half, face);
    }
    /// n.(o + t d) = distance
    template <class Emit>
    static void flat(const V& n, Real distance, const V& o, const V& d, int face, Emit emit) {
        const Real rate = dot(n, d);
        if (rate != 0) emit((distance - dot(n, o)) / rate, face);
    }

    Shape shape_;
    bool inverse_;
    V rows_[3];  // of the inverse linear map
    V shift_;
};

}  // namespace meniscus::oracle
