#pragma once

#include <array>
#include <vector>

#include "geom/mesh.hpp"
#include "tests/oracle/real.hpp"

namespace meniscus::oracle {

/// A closed mesh, without any hierarchy: every triangle is asked every time. What lies inside is
/// counted along a line in a direction of its own.
template <class Real>
class MeshBody {
public:
    using V = Vector<Real>;

    explicit MeshBody(const geom::Mesh& mesh) {
        for (std::size_t i = 0; i < mesh.triangles->size(); ++i) {
            const auto corners = mesh.triangles->corners(geom::Face(i));
            triangles_.push_back(
                {widen<Real>(corners[0]), widen<Real>(corners[1]), widen<Real>(corners[2])});
        }
        low_ = high_ = triangles_[0][0];
        for (const auto& triangle : triangles_) {
            for (const V& v : triangle) {
                low_ = {v.x < low_.x ? v.x : low_.x, v.y < low_.y ? v.y : low_.y,
                        v.z < low_.z ? v.z : low_.z};
                high_ = {v.x > high_.x ? v.x : high_.x, v.y > high_.y ? v.y : high_.y,
                         v.z > high_.z ? v.z : high_.z};
            }
        }
    }

    bool inside(const V& p) const {
        if (p.x < low_.x || p.y < low_.y || p.z < low_.z || p.x > high_.x || p.y > high_.y ||
            p.z > high_.z)
            return false;
        const V d{Real(0.3141592653589793), Real(0.2718281828459045), Real(0.5772156649015329)};
        int depth = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            meet(i, p, d, Real(0), [&](Real t, bool entering) {
                if (t > 0) depth += entering ? -1 : 1;
            });
        }
        return depth > 0;
    }

    template <class Emit>
    void meetings(const V& o, const V& d, Emit emit) const {
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            meet(i, o, d, Real(1e-9), [&](Real t, bool) { emit(t, int(i)); });
    }

    V gradient(int face, const V&) const {
        const auto& [a, b, c] = triangles_[std::size_t(face)];
        return cross(b - a, c - a);
    }

private:
    /// The line's meeting with the triangle, whose edges lie farther out by the share `beyond`.
    template <class Emit>
    void meet(std::size_t index, const V& o, const V& d, Real beyond, Emit emit) const {
        const auto& [a, b, c] = triangles_[index];
        const V n = cross(b - a, c - a);
        const Real rate = dot(n, d);
        if (rate == 0) return;
        const V p = a - o, q = b - o, r = c - o;
        // The volumes that the line's direction spans with the edges.
        const Real u = dot(d, cross(q, r)), v = dot(d, cross(r, p)), w = dot(d, cross(p, q));
        const Real slack = beyond * absolute(rate);
        const Real sign = rate < 0 ? -1 : 1;
        if (sign * u < -slack || sign * v < -slack || sign * w < -slack) return;
        emit(dot(n, p) / rate, rate < 0);
    }

    std::vector<std::array<V, 3>> triangles_;
    V low_, high_;
};

}  // namespace meniscus::oracle
