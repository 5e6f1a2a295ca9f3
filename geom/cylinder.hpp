#pragma once

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// cylinder { <0, -1, 0>, <0, 1, 0>, 1 }; `open` takes the two caps away.
struct Cylinder {
    Vec3 base{0.0, -1.0, 0.0};
    Vec3 cap{0.0, 1.0, 0.0};
    double radius = 1.0;
    bool open = false;

    static constexpr auto keyword = "cylinder";
    static constexpr auto fields =
        std::tuple{Field{"base", &Cylinder::base}, Field{"cap", &Cylinder::cap},
                   Field{"radius", &Cylinder::radius}};
    static constexpr auto flags = std::tuple{Flag{"open", &Cylinder::open}};

    static constexpr Face side_face = 0, base_face = 1, cap_face = 2;

    bool is_closed() const { return !open; }
    Bounds bounds() const;
    double magnitude() const { return glm::max(max_abs(base), max_abs(cap)) + radius; }

    Interval interval(const Ray& ray, Face pin) const;
    void hits(const Ray& ray, Crossings& out) const;
    bool contains(const Vec3& p) const;
    Vec3 normal(Face face, const Vec3& p) const { return normal(face, Ray{p}); }
    /// At the point's exact origin.
    Vec3 normal(Face face, const Ray& point) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

}  // namespace meniscus::geom
