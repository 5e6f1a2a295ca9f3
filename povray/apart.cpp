#include "povray/apart.hpp"

#include <algorithm>
#include <cmath>

#include "geom/profile.hpp"

namespace meniscus::povray {
namespace {

using namespace geom;

/// A lower bound of the distance from a point outside the shape to it; 0 where none is known.
double distance(const Sphere& s, const Vec3& p) { return glm::length(p - s.center) - s.radius; }
double distance(const Box& s, const Vec3& p) {
    return glm::length(p - glm::clamp(p, s.low(), s.high()));
}
double distance(const Plane& s, const Vec3& p) {
    return glm::dot(p, glm::normalize(s.direction)) - s.distance;
}
double distance(const Lathe& s, const Vec3& p) {
    const Vec2 q{std::hypot(p.x, p.z), p.y};
    const Profile profile(s.spline(), s.points());
    if (profile.contains(q)) return 0.0;
    double least = infinity;
    for (const auto& piece : profile.pieces())
        least = std::min(least, glm::length(piece.at(piece.nearest(q)) - q));
    return least;
}
double distance(const auto&, const Vec3&) { return 0.0; }

double distance(const PlacedShape& shape, const Vec3& p) {
    const Mat3& m = shape.transform().linear();
    for (int i = 0; i < 3; ++i) {
        // rotations and moves alone: others would need the least scale
        if (std::abs(glm::length(m[i]) - 1.0) > 1e-9) return 0.0;
        if (std::abs(glm::dot(m[i], m[(i + 1) % 3])) > 1e-9) return 0.0;
    }
    const Vec3 own = shape.transform().to_local(p);
    return std::visit([&](const auto& s) { return distance(s, own); }, shape.shape());
}

/// Of a box, where it is nearest to the half-space.
bool is_apart_from(const Bounds& box, const PlacedShape& shape, double margin) {
    const auto* plane = std::get_if<Plane>(&shape.shape());
    if (!plane || !shape.transform().is_identity() || !box.is_finite()) return false;
    const Vec3 n = glm::normalize(plane->direction);
    Vec3 corner;
    for (int i = 0; i < 3; ++i) corner[i] = n[i] > 0.0 ? box.low[i] : box.high[i];
    return distance(*plane, corner) > margin;
}

}  // namespace

bool are_apart(const tracer::Part& a, const tracer::Part& b, double margin) {
    if (a.inverse || b.inverse) return false;
    if (!overlap(a.shape.bounds().padded(margin), b.shape.bounds())) return true;
    const std::pair<const tracer::Part*, const tracer::Part*> orders[] = {{&a, &b}, {&b, &a}};
    for (const auto& [first, second] : orders) {
        if (is_apart_from(first->shape.bounds(), second->shape, margin)) return true;
        const auto* sphere = std::get_if<Sphere>(&first->shape.shape());
        if (sphere && first->shape.transform().is_identity() &&
            distance(second->shape, sphere->center) > sphere->radius + margin)
            return true;
    }
    return false;
}

}  // namespace meniscus::povray
