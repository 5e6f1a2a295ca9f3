#pragma once

#include <memory>
#include <vector>

#include "geom/primitive.hpp"

namespace meniscus::geom {

class Profile;

/// How a lathe joins its points: each spline with the points POV-Ray uses for it.
enum class Spline {
    linear,     // through all points
    quadratic,  // the first point only shapes the curve
    cubic,      // Catmull-Rom: the first and the last point only shape it
    bezier,     // four points a piece
};

/// lathe { linear_spline count, points }: a profile of (radius, height) turned about the y axis. It
/// is a solid if every chain of the profile closes: it ends where it began, or both its ends lie on
/// the axis. The default is a tumbler.
class Lathe {
public:
    Lathe();
    /// Throws std::invalid_argument, with a sentence for the scene's author, for too few points or
    /// a negative radius.
    Lathe(Spline spline, std::vector<Vec2> points);

    static constexpr auto keyword = "lathe";
    static constexpr auto fields = std::tuple<>{};
    static constexpr auto flags = std::tuple<>{};

    Spline spline() const { return spline_; }
    const std::vector<Vec2>& points() const { return points_; }
    const Profile& profile() const { return *profile_; }

    bool is_closed() const;
    Bounds bounds() const;
    double magnitude() const;

    void crossings(const Ray& ray, Crossings& out) const;
    void hits(const Ray& ray, Crossings& out) const;
    bool contains(const Vec3& p) const;
    Vec3 normal(Face face, const Vec3& p) const;
    Vec3 to_face(Face face, const Ray& point) const;

private:
    Spline spline_;
    std::vector<Vec2> points_;
    std::shared_ptr<const Profile> profile_;
};

}  // namespace meniscus::geom
