#pragma once

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// disc { <0, 0, 0>, <0, 1, 0>, 1, 0 }: a flat ring where the hole's radius is not 0.
struct Disc {
    Vec3 center{0.0};
    Vec3 direction{0.0, 1.0, 0.0};
    double radius = 1.0;
    double hole_radius = 0.0;

    static constexpr auto keyword = "disc";
    static constexpr auto fields =
        std::tuple{Field{"center", &Disc::center}, Field{"normal", &Disc::direction},
                   Field{"radius", &Disc::radius}, Field{"hole_radius", &Disc::hole_radius, true}};
    static constexpr auto flags = std::tuple<>{};

    bool is_closed() const { return false; }
    Bounds bounds() const;
    double magnitude() const { return max_abs(center) + radius; }

    void hits(const Ray& ray, Crossings& out) const;
    Vec3 normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

}  // namespace meniscus::geom
