#include "geom/triangle.hpp"

#include "geom/cylindrical.hpp"
#include "geom/watertight.hpp"

namespace meniscus::geom {

Bounds Triangle::bounds() const {
    Bounds result;
    for (const Vec3& p : {a, b, c}) result.extend(p);
    return result;
}

double Triangle::magnitude() const {
    return glm::max(max_abs(a), glm::max(max_abs(b), max_abs(c)));
}

void Triangle::hits(const Ray& ray, Crossings& out) const {
    if (const auto hit = TriangleLine(ray).hit(a, b, c)) out.push_back({hit->t, 0, hit->entering});
}

Vec3 Triangle::normal(Face, const Vec3&) const { return glm::normalize(glm::cross(b - a, c - a)); }

Vec3 Triangle::shading_normal(Face face, const Vec3& p) const {
    const Vec3 flat = normal(face, p);
    return smooth ? interpolated_normal({a, b, c}, {na, nb, nc}, flat, p) : flat;
}

Vec3 Triangle::to_face(Face face, const Ray& point) const {
    return to_plane(point.from(a), normal(face, a));
}

Vec3 interpolated_normal(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals,
                         const Vec3& flat, const Vec3& p) {
    const auto& [a, b, c] = corners;
    const double wa = glm::dot(flat, glm::cross(b - p, c - p));
    const double wb = glm::dot(flat, glm::cross(c - p, a - p));
    const double wc = glm::dot(flat, glm::cross(a - p, b - p));
    const auto unit = [](const Vec3& n) {
        const double length = glm::length(n);
        return length > 0.0 ? n / length : Vec3{0.0};
    };
    const Vec3 n = unit(wa * unit(normals[0]) + wb * unit(normals[1]) + wc * unit(normals[2]));
    const double side = glm::dot(n, flat);
    return side > 0.0 ? n : side < 0.0 ? -n : flat;
}

}  // namespace meniscus::geom
