#pragma once

#include <optional>

#include "geom/ray.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

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
    std::optional<Hit> hit(const Vec3& a, const Vec3& b, const Vec3& c) const;

private:
    Vec3 sheared(const Vec3& vertex) const;

    Ray ray_;
    int x_, y_, z_;  // the axes, permuted so that the direction is longest along z_
    Vec3 shear_;
    bool backwards_;  // against the axis z_
};

}  // namespace meniscus::geom
