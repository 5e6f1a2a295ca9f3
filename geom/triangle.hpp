#pragma once

#include <array>

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }; smooth_triangle gives each corner a normal to
/// shade with.
struct Triangle {
    Vec3 a{0.0, 0.0, 0.0}, b{1.0, 0.0, 0.0}, c{0.0, 1.0, 0.0};
    bool smooth = false;
    Vec3 na{0.0}, nb{0.0}, nc{0.0};  // used if smooth; of any length

    static constexpr auto keyword = "triangle";
    static constexpr auto fields =
        std::tuple{Field{"a", &Triangle::a}, Field{"b", &Triangle::b}, Field{"c", &Triangle::c}};
    static constexpr auto flags = std::tuple<>{};

    bool is_closed() const { return false; }
    Bounds bounds() const;
    double magnitude() const;

    void hits(const Ray& ray, Crossings& out) const;
    Vec3 normal(Face face, const Vec3& p) const;
    Vec3 shading_normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

/// The mean of a triangle's corner normals at a point of it, turned to the side of its `flat`
/// normal. Unit length.
Vec3 interpolated_normal(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals,
                         const Vec3& flat, const Vec3& p);

}  // namespace meniscus::geom
