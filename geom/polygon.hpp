#pragma once

#include <vector>

#include "geom/primitive.hpp"

namespace meniscus::geom {

/// polygon { count, points }: one or more closed loops in a plane, each ending with its first point
/// again; holes by the even-odd rule. The default is a unit square.
class Polygon {
public:
    Polygon();
    /// Throws std::invalid_argument, with a sentence for the scene's author, unless the points span
    /// a plane and lie in it.
    explicit Polygon(std::vector<Vec3> points);

    static constexpr auto keyword = "polygon";
    static constexpr auto fields = std::tuple<>{};
    static constexpr auto flags = std::tuple<>{};

    const std::vector<Vec3>& points() const { return points_; }

    bool is_closed() const { return false; }
    Bounds bounds() const { return bounds_; }
    double magnitude() const;

    void hits(const Ray& ray, Crossings& out) const;
    Vec3 normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;

private:
    bool covers(const Vec3& p) const;

    std::vector<Vec3> points_;
    std::vector<std::size_t> loop_starts_;  // and the end of the last
    Bounds bounds_;
    Vec3 normal_{0.0};
    int axis_ = 2;  // the largest coordinate of the normal: dropped for the test in two dimensions
};

}  // namespace meniscus::geom
