#pragma once

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// torus { 1, 0.25 }: a ring about the y axis. Where minor > major it closes over the hole; the
/// inside is then all that the outer skin encloses.
struct Torus {
    double major = 1.0;
    double minor = 0.25;

    static constexpr auto keyword = "torus";
    static constexpr auto fields =
        std::tuple{Field{"major", &Torus::major}, Field{"minor", &Torus::minor}};
    static constexpr auto flags = std::tuple<>{};

    bool is_closed() const { return true; }
    Bounds bounds() const;
    double magnitude() const { return major + minor; }

    void crossings(const Ray& ray, Crossings& out) const;
    bool contains(const Vec3& p) const;
    Vec3 normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

}  // namespace meniscus::geom
