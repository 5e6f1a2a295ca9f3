#include "tracer/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "geom/cylindrical.hpp"
#include "geom/profile.hpp"

namespace meniscus::tracer {
namespace {

using geom::Vec3;

using Kind = Level::Kind;
using enum Level::Kind;

struct Levels {
    Vec3 origin;
    std::vector<Level>& all;

    void add(Kind kind, const Vec3& point, double at, const Vec3& direction = Vec3{0.0},
             double a = 0.0, double b = 0.0) {
        all.push_back({kind, point, direction, a, b, at});
    }
    void add_plane(const Vec3& n, double at) {
        const double sign = n.x != 0.0 ? n.x : n.y != 0.0 ? n.y : n.z;
        add(planes, Vec3{0.0}, sign < 0.0 ? -at : at, sign < 0.0 ? -n : n);
    }
    /// a * radius + b * height = c about an axis through `foot`, (a, b) a unit vector.
    void add_round(const Vec3& foot, const Vec3& along, double a, double b, double c) {
        if (a == 0.0) return add_plane(along, c / b);
        const double sign = a < 0.0 ? -1.0 : 1.0;
        add(round, foot, sign * c, along, sign * a, sign * b);
    }
    template <class Round>
    void add_frustum(const Round& shape, double base_radius, double cap_radius) {
        geom::Axis axis(shape.base - origin, shape.cap - origin);
        const Vec3 d = axis.direction;
        if ((d.x != 0.0 ? d.x : d.y != 0.0 ? d.y : d.z) < 0.0) {
            axis = geom::Axis(shape.cap - origin, shape.base - origin);
            std::swap(base_radius, cap_radius);
        }
        const double height = glm::dot(axis.base, axis.direction);
        const double growth = (cap_radius - base_radius) / axis.length;
        const double a = 1.0 / std::sqrt(1.0 + growth * growth);
        add_round(axis.base - height * axis.direction, axis.direction, a, -growth * a,
                  a * (base_radius - growth * height));
        add_plane(axis.direction, height);
        add_plane(axis.direction, height + axis.length);
    }

    void operator()(const geom::Sphere& sphere) {
        add(spheres, sphere.center - origin, sphere.radius);
    }
    void operator()(const geom::Box& box) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 n{0.0};
            n[axis] = 1.0;
            add_plane(n, box.corner1[axis] - origin[axis]);
            add_plane(n, box.corner2[axis] - origin[axis]);
        }
    }
    void operator()(const geom::Plane& plane) {
        const Vec3 n = plane.normal(0, Vec3{0.0});
        add_plane(n, plane.distance - glm::dot(n, origin));
    }
    void operator()(const geom::Cylinder& cylinder) {
        add_frustum(cylinder, cylinder.radius, cylinder.radius);
    }
    void operator()(const geom::Cone& cone) {
        add_frustum(cone, cone.base_radius, cone.cap_radius);
    }
    void operator()(const geom::Torus& torus) { add(rings, {torus.major, 0.0, 0.0}, torus.minor); }
    void operator()(const geom::Lathe& lathe) {
        bool is_curved = false;
        for (const geom::ProfilePiece& piece : lathe.profile().pieces()) {
            is_curved = is_curved || !piece.straight;
            if (!piece.straight) continue;
            add_round(Vec3{0.0}, {0.0, 1.0, 0.0}, piece.line.a, piece.line.b, piece.line.c);
        }
        if (!is_curved) return;
        for (const geom::Vec2& point : lathe.points()) {
            add(radii, Vec3{0.0}, point.x);
            add(heights, Vec3{0.0}, point.y);
        }
    }
    template <class Other>
    void operator()(const Other&) {}
};

}  // namespace

void add_levels(const geom::Shape& shape, const Vec3& origin, std::vector<Level>& levels) {
    std::visit(Levels{origin, levels}, shape);
}

bool has_film(const std::vector<Level>& levels, double size, double rounding, double film) {
    // Rounding must not tell relatives apart: they agree in nine digits.
    const auto key = [&](const Level& level) {
        const Vec3 point = glm::round(1e9 / size * level.point),
                   direction = glm::round(1e9 * level.direction);
        return std::array<double, 9>{double(level.kind),
                                     point.x,
                                     point.y,
                                     point.z,
                                     direction.x,
                                     direction.y,
                                     direction.z,
                                     std::round(1e9 * level.a),
                                     std::round(1e9 * level.b)};
    };
    std::vector<std::pair<std::array<double, 9>, double>> sorted;
    for (const Level& level : levels) sorted.emplace_back(key(level), level.at);
    std::ranges::sort(sorted);
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const double distance = sorted[i].second - sorted[i - 1].second;
        if (sorted[i].first == sorted[i - 1].first && distance > rounding && distance < film)
            return true;
    }
    return false;
}

}  // namespace meniscus::tracer
