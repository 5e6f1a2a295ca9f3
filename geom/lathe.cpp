#include "geom/lathe.hpp"

#include <algorithm>
#include <utility>

#include "geom/lathe_roots.hpp"

namespace meniscus::geom {

namespace {

Vec2 radius_and_height(const Vec3& p) { return {glm::length(Vec2{p.x, p.z}), p.y}; }

/// From the half-plane of radius and height into space, at the angle of `p`.
Vec3 turned(const Vec2& v, const Vec3& p, double radius) {
    const Vec2 out = radius > 0.0 ? Vec2{p.x, p.z} / radius : Vec2{1.0, 0.0};
    return {v.x * out.x, v.y, v.x * out.y};
}

/// The roots of the whole line, sorted, with t of the ray.
LatheRoots sorted_roots(const Profile& profile, const Ray& ray) {
    const LatheLine line(ray, 0.5 * (profile.low().y + profile.high().y));
    LatheRoots found;
    const double reach = profile.high().x;
    if (line.closest2 > reach * reach) return found;
    append_roots(line, profile, found);
    std::sort(found.begin(), found.end(), [](auto& a, auto& b) { return a.t < b.t; });
    for (LatheRoot& root : found) root.t = line.ray_t(root.t);
    return found;
}

}  // namespace

Lathe::Lathe()
    : Lathe(Spline::linear,
            {{0.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {0.75, 1.0}, {0.75, -0.75}, {0.0, -0.75}}) {}

Lathe::Lathe(Spline spline, std::vector<Vec2> points)
    : spline_(spline),
      points_(std::move(points)),
      profile_(std::make_shared<const Profile>(spline_, points_)) {}

bool Lathe::is_closed() const { return profile_->is_closed(); }

Bounds Lathe::bounds() const {
    const double radius = profile_->high().x;
    return {{-radius, profile_->low().y, -radius}, {radius, profile_->high().y, radius}};
}

double Lathe::magnitude() const {
    const Bounds box = bounds();
    return glm::max(max_abs(box.low), max_abs(box.high));
}

void Lathe::crossings(const Ray& ray, Crossings& out) const {
    bool entering = false;
    for (const LatheRoot& root : sorted_roots(*profile_, ray)) {
        out.push_back({root.t, root.piece, entering = !entering});
    }
}

void Lathe::hits(const Ray& ray, Crossings& out) const {
    if (is_closed()) return crossings(ray, out);
    for (const LatheRoot& root : sorted_roots(*profile_, ray)) {
        const Vec3 n = normal(root.piece, ray.at(root.t));
        out.push_back({root.t, root.piece, glm::dot(n, ray.direction) < 0.0});
    }
}

bool Lathe::contains(const Vec3& p) const { return profile_->contains(radius_and_height(p)); }

Vec3 Lathe::normal(Face face, const Vec3& p) const {
    const Vec2 q = radius_and_height(p);
    return glm::normalize(turned(profile_->foot(face, q).normal, p, q.x));
}

Vec3 Lathe::to_face(Face face, const Ray& point) const {
    const Vec3 p = point.from(Vec3{0.0});
    const Vec2 q = radius_and_height(p);
    const auto [normal, distance] = profile_->foot(face, q);
    return turned(-distance * normal, p, q.x);
}

}  // namespace meniscus::geom
