#pragma once

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// sphere { <0, 0, 0>, 1 }
struct Sphere {
    Vec3 center{0.0};
    double radius = 1.0;

    static constexpr auto keyword = "sphere";
    static constexpr auto fields =
        std::tuple{Field{"center", &Sphere::center}, Field{"radius", &Sphere::radius}};
    static constexpr auto flags = std::tuple<>{};

    bool is_closed() const { return true; }
    Bounds bounds() const { return {center - Vec3{radius}, center + Vec3{radius}}; }
    double magnitude() const { return max_abs(center) + radius; }

    Interval interval(const Ray& ray, Face pin) const;
    bool contains(const Vec3& p) const;
    Vec3 normal(Face face, const Vec3& p) const { return normal(face, Ray{p}); }
    /// At the point's exact origin.
    Vec3 normal(Face face, const Ray& point) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

}  // namespace meniscus::geom
