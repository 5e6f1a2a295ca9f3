#pragma once

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// cone { <0, -1, 0>, 1, <0, 1, 0>, 0 }: a frustum; either end may be the point or the wider one.
/// `open` takes the caps away.
struct Cone {
    Vec3 base{0.0, -1.0, 0.0};
    double base_radius = 1.0;
    Vec3 cap{0.0, 1.0, 0.0};
    double cap_radius = 0.0;
    bool open = false;

    static constexpr auto keyword = "cone";
    static constexpr auto fields =
        std::tuple{Field{"base", &Cone::base}, Field{"base_radius", &Cone::base_radius},
                   Field{"cap", &Cone::cap}, Field{"cap_radius", &Cone::cap_radius}};
    static constexpr auto flags = std::tuple{Flag{"open", &Cone::open}};

    static constexpr Face side_face = 0, base_face = 1, cap_face = 2;

    bool is_closed() const { return !open; }
    Bounds bounds() const;
    double magnitude() const;

    Interval interval(const Ray& ray, Face pin) const;
    void hits(const Ray& ray, Crossings& out) const;
    bool contains(const Vec3& p) const;
    Vec3 normal(Face face, const Vec3& p) const { return normal(face, Ray{p}); }
    /// At the point's exact origin.
    Vec3 normal(Face face, const Ray& point) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

}  // namespace meniscus::geom
