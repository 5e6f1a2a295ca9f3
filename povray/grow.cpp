#include "povray/grow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geom/cylindrical.hpp"
#include "geom/placed_shape.hpp"
#include "povray/error.hpp"

namespace meniscus::povray {
namespace {

using namespace geom;

/// How far a plane moves in the shape's own frame when it moves by 1 in the world.
double own_distance(const Transform& transform, const Vec3& own_normal) {
    return glm::length(transform.normal(own_normal));
}

double least_scale(const Transform& transform) {
    const Mat3& m = transform.linear();
    return std::min({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
}

bool is_similarity(const Transform& transform) {
    const Mat3& m = transform.linear();
    const double s = glm::dot(m[0], m[0]), tolerance = 1e-9 * s;
    return std::abs(glm::dot(m[1], m[1]) - s) < tolerance &&
           std::abs(glm::dot(m[2], m[2]) - s) < tolerance &&
           std::abs(glm::dot(m[0], m[1])) < tolerance &&
           std::abs(glm::dot(m[1], m[2])) < tolerance && std::abs(glm::dot(m[2], m[0])) < tolerance;
}

void require_size(double size) {
    if (!(size > 0.0)) throw std::invalid_argument("it is smaller than what is taken from it");
}

void grow(Sphere& s, Transform& transform, double d) {
    if (is_similarity(transform)) {
        s.radius += d / glm::length(transform.linear()[0]);
        return require_size(s.radius);
    }
    Vec3 factors;
    for (int i = 0; i < 3; ++i) {
        factors[i] = 1.0 + d / (s.radius * glm::length(transform.linear()[i]));
        require_size(factors[i]);
    }
    transform = Transform::translation(-s.center)
                    .then(Transform::scaling(factors))
                    .then(Transform::translation(s.center))
                    .then(transform);
}

void grow(Box& s, Transform& transform, double d) {
    Vec3 low = s.low(), high = s.high();
    for (int i = 0; i < 3; ++i) {
        Vec3 normal{0.0};
        normal[i] = 1.0;
        const double own = d * own_distance(transform, normal);
        low[i] -= own;
        high[i] += own;
        require_size(high[i] - low[i]);
    }
    s.corner1 = low;
    s.corner2 = high;
}

void grow(Plane& s, Transform& transform, double d) {
    const Vec3 unit = glm::normalize(s.direction);
    s.direction = unit;
    s.distance += d * own_distance(transform, unit);
}

/// Both ends outwards; the side's radius is `radius_at` of the new ends.
template <class Round>
void grow_ends(Round& s, const Axis& axis, const Transform& transform, double d) {
    const double own = d * own_distance(transform, axis.direction);
    require_size(axis.length + 2.0 * own);
    s.base -= own * axis.direction;
    s.cap += own * axis.direction;
}

/// The own distance of a round side, whose normals lean by `slope` along the axis: where the shape
/// is stretched across its axis, the larger.
double side_distance(const Transform& transform, const Axis& axis, double slope) {
    const Vec3 u = any_perpendicular(axis.direction), v = glm::cross(axis.direction, u);
    const double norm = std::sqrt(1.0 + slope * slope);
    const Vec3 lean = -slope * axis.direction;
    return std::max(own_distance(transform, (u + lean) / norm),
                    own_distance(transform, (v + lean) / norm));
}

void grow(Cylinder& s, Transform& transform, double d) {
    const Axis axis(s.base, s.cap);
    s.radius += d * side_distance(transform, axis, 0.0);
    require_size(s.radius);
    grow_ends(s, axis, transform, d);
}

void grow(Cone& s, Transform& transform, double d) {
    const Axis axis(s.base, s.cap);
    const double slope = (s.cap_radius - s.base_radius) / axis.length;
    const double out = d * side_distance(transform, axis, slope) * std::sqrt(1.0 + slope * slope);
    const double own = d * own_distance(transform, axis.direction);
    // the side's line, moved, at the moved ends; where it meets the axis before, the tip is there
    double low = -own, high = axis.length + own;
    const double at_base = s.base_radius + out;
    const auto radius = [&](double y) { return at_base + slope * y; };
    if (radius(high) < 0.0) high = -at_base / slope;
    if (radius(low) < 0.0) low = -at_base / slope;
    require_size(high - low);
    const Vec3 base = s.base;
    s.base = base + low * axis.direction;
    s.cap = base + high * axis.direction;
    s.base_radius = std::max(radius(low), 0.0);
    s.cap_radius = std::max(radius(high), 0.0);
}

void grow(Torus& s, Transform& transform, double d) {
    s.minor += d / least_scale(transform);
    require_size(s.minor);
}

void grow(Lathe& s, Transform& transform, double d) {
    const Mat3& m = transform.linear();
    const double across = glm::length(m[0]), along = glm::length(m[1]);
    const bool is_straight = std::abs(glm::dot(m[0], m[1])) < 1e-9 * across * along &&
                             std::abs(glm::dot(m[1], m[2])) < 1e-9 * across * along &&
                             std::abs(glm::dot(m[0], m[2])) < 1e-9 * across * across &&
                             std::abs(glm::length(m[2]) - across) < 1e-9 * across;
    if (!is_straight || across == along) {
        s = offset(s, d / least_scale(transform));
        return;
    }
    // Stretched along its axis: the stretch goes into the profile.
    auto points = s.points();
    for (Vec2& p : points) p *= Vec2{across, along};
    s = offset(Lathe(s.spline(), std::move(points)), d);
    transform = Transform::scaling({1.0 / across, 1.0 / along, 1.0 / across}).then(transform);
}

void grow(Mesh& s, Transform& transform, double d) {
    auto soup = soup_of(*s.triangles, transform);
    transform = Transform{};
    s.triangles = std::make_shared<const TriangleMesh>(offset(TriangleMesh(std::move(soup)), d));
}

void grow(Disc&, Transform&, double) {}
void grow(Polygon&, Transform&, double) {}
void grow(Triangle&, Transform&, double) {}

}  // namespace

scene::Object grown(const scene::Object& object, double distance) {
    if (distance == 0.0) return object;
    const PlacedShape placed(object.shape, object.transform);
    scene::Object result = object;
    result.shape = placed.shape();
    result.transform = placed.transform();
    const double outwards = object.inverse ? -distance : distance;
    try {
        std::visit([&](auto& shape) { grow(shape, result.transform, outwards); }, result.shape);
    } catch (const std::invalid_argument& error) {
        throw ExportError(
            object.location,
            fmt::format("'{}' cannot be made {} by {:.3g}: {}", object.name,
                        outwards > 0.0 ? "larger" : "smaller", std::abs(distance), error.what()));
    }
    return result;
}

}  // namespace meniscus::povray
