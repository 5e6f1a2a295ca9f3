#pragma once

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// plane { <0, 1, 0>, 0 }: the half-space below it is its inside. `normal` is made unit length
/// where it is used; `distance` is counted along the unit normal.
struct Plane {
    Vec3 direction{0.0, 1.0, 0.0};
    double distance = 0.0;

    static constexpr auto keyword = "plane";
    static constexpr auto fields =
        std::tuple{Field{"normal", &Plane::direction}, Field{"distance", &Plane::distance}};
    static constexpr auto flags = std::tuple<>{};

    bool is_closed() const { return true; }
    Bounds bounds() const { return Bounds::everything(); }
    double magnitude() const { return glm::abs(distance); }

    Interval interval(const Ray& ray, Face pin) const;
    bool contains(const Vec3& p) const;
    Vec3 normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

}  // namespace meniscus::geom
