#pragma once

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// box { <-1, -1, -1>, <1, 1, 1> }: any two opposite corners. Faces: 2 * axis, plus 1 on the upper
/// side. A line that runs along an axis within a face belongs to the box if that is its lower face:
/// of two stacked boxes just one has it.
struct Box {
    Vec3 corner1{-1.0};
    Vec3 corner2{1.0};

    static constexpr auto keyword = "box";
    static constexpr auto fields =
        std::tuple{Field{"corner1", &Box::corner1}, Field{"corner2", &Box::corner2}};
    static constexpr auto flags = std::tuple<>{};

    Vec3 low() const { return glm::min(corner1, corner2); }
    Vec3 high() const { return glm::max(corner1, corner2); }

    bool is_closed() const { return true; }
    Bounds bounds() const { return {low(), high()}; }
    double magnitude() const { return glm::max(max_abs(corner1), max_abs(corner2)); }

    Interval interval(const Ray& ray, Face pin) const;
    bool contains(const Vec3& p) const;
    Vec3 normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;
};

}  // namespace meniscus::geom
