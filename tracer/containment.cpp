#include "tracer/containment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geom/bvh.hpp"

namespace meniscus::tracer {
namespace {

using geom::PlacedShape;
using geom::Vec3;

/// A circle, thickened by a ball that runs along it: a point, a ball and a torus are special cases.
/// A shape is inside a convex one if all rings are whose hull holds it.
struct Ring {
    Vec3 center;
    Vec3 axis{0.0, 1.0, 0.0};  // unit length
    double radius = 0.0, thickness = 0.0;
};
using Rings = std::vector<Ring>;

Ring point(const Vec3& p) { return {p}; }

void add_corners(const geom::Bounds& box, Rings& rings) {
    for (int i = 0; i < 8; ++i) {
        rings.push_back(point({i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                               i & 4 ? box.high.z : box.low.z}));
    }
}

// Each shape's rings, in its own frame.

Rings rings_of(const geom::Sphere& s) { return {{s.center, {0.0, 1.0, 0.0}, 0.0, s.radius}}; }
Rings rings_of(const geom::Cylinder& c) {
    const Vec3 axis = glm::normalize(c.cap - c.base);
    return {{c.base, axis, c.radius, 0.0}, {c.cap, axis, c.radius, 0.0}};
}
Rings rings_of(const geom::Cone& c) {
    const Vec3 axis = glm::normalize(c.cap - c.base);
    return {{c.base, axis, c.base_radius, 0.0}, {c.cap, axis, c.cap_radius, 0.0}};
}
Rings rings_of(const geom::Torus& t) { return {{Vec3{0.0}, {0.0, 1.0, 0.0}, t.major, t.minor}}; }
Rings rings_of(const geom::Mesh& mesh) {
    Rings rings;
    for (std::size_t i = 0; i < mesh.triangles->size(); ++i) {
        for (const Vec3& corner : mesh.triangles->corners(geom::Face(i)))
            rings.push_back(point(corner));
    }
    return rings;
}
Rings rings_of(const geom::Lathe& lathe) {
    Rings rings;
    if (lathe.spline() != geom::Spline::linear) return rings;
    for (const auto& p : lathe.points())
        rings.push_back({{0.0, p.y, 0.0}, {0.0, 1.0, 0.0}, p.x, 0.0});
    return rings;
}
Rings rings_of(const geom::Box& box) {
    Rings rings;
    add_corners(box.bounds(), rings);
    return rings;
}
template <class Other>
Rings rings_of(const Other&) {
    return {};
}

/// The factor of a map that keeps angles; none for others.
std::optional<double> uniform_scale(const geom::Mat3& m) {
    const double scale = glm::length(m[0]);
    for (int i = 0; i < 3; ++i) {
        if (std::abs(glm::length(m[i]) - scale) > 1e-12 * scale) return std::nullopt;
        if (std::abs(glm::dot(m[i], m[(i + 1) % 3])) > 1e-12 * scale * scale) return std::nullopt;
    }
    return scale;
}

/// Rings under a map: exactly, or, where circles become ellipses, the corners of a box round each;
/// then they are not `exact`.
Rings moved(const Rings& rings, const geom::Transform& map, bool& exact) {
    if (map.is_identity()) return rings;
    const auto scale = uniform_scale(map.linear());
    Rings result;
    for (const Ring& ring : rings) {
        if (scale) {
            result.push_back({map.point(ring.center), glm::normalize(map.vector(ring.axis)),
                              *scale * ring.radius, *scale * ring.thickness});
            continue;
        }
        if (ring.radius + ring.thickness > 0.0) exact = false;
        const auto first = result.size();
        add_corners(geom::Bounds{ring.center, ring.center}.padded(ring.radius + ring.thickness),
                    result);
        for (auto i = first; i < result.size(); ++i) result[i].center = map.point(result[i].center);
    }
    return result;
}

/// How far the ring reaches along a unit vector.
double reach(const Ring& ring, const Vec3& n) {
    const double across = std::sqrt(std::max(0.0, 1.0 - std::pow(glm::dot(n, ring.axis), 2)));
    return glm::dot(n, ring.center) + ring.radius * across + ring.thickness;
}

// How far a ring sticks out of a shape, at the most; below 0: it lies inside. None: not known.

std::optional<double> excess(const geom::Plane& plane, const Ring& ring) {
    return reach(ring, plane.normal(0, Vec3{0.0})) - plane.distance;
}
std::optional<double> excess(const geom::Box& box, const Ring& ring) {
    double most = -geom::infinity;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 n{0.0};
        n[axis] = 1.0;
        most =
            std::max({most, reach(ring, n) - box.high()[axis], reach(ring, -n) + box.low()[axis]});
    }
    return most;
}
std::optional<double> excess(const geom::Sphere& sphere, const Ring& ring) {
    const Vec3 away = ring.center - sphere.center;
    const double along = glm::dot(away, ring.axis);
    const double across = glm::length(away - along * ring.axis);
    return std::hypot(along, across + ring.radius) + ring.thickness - sphere.radius;
}
std::optional<double> excess(const geom::Cylinder& cylinder, const Ring& ring) {
    const Vec3 axis = glm::normalize(cylinder.cap - cylinder.base);
    const Vec3 away = ring.center - cylinder.base;
    const double across = glm::length(away - glm::dot(away, axis) * axis);
    return std::max({reach(ring, axis) - glm::dot(axis, cylinder.cap),
                     reach(ring, -axis) + glm::dot(axis, cylinder.base),
                     across + ring.radius + ring.thickness - cylinder.radius});
}
template <class Other>
std::optional<double> excess(const Other&, const Ring&) {
    return std::nullopt;
}

using Triangle = std::array<Vec3, 3>;

/// Whether two triangles are farther apart than `room`, along one of the directions that decide
/// that (the separating axes: both normals, and what is across two edges).
bool are_apart(const Triangle& a, const Triangle& b, double room) {
    const auto separates = [&](const Vec3& axis) {
        const double length = glm::length(axis);
        if (!(length > 0.0)) return false;
        const auto [a_low, a_high] =
            std::minmax({glm::dot(a[0], axis), glm::dot(a[1], axis), glm::dot(a[2], axis)});
        const auto [b_low, b_high] =
            std::minmax({glm::dot(b[0], axis), glm::dot(b[1], axis), glm::dot(b[2], axis)});
        return std::max(a_low - b_high, b_low - a_high) > room * length;
    };
    const auto edges = [](const Triangle& t) {
        return Triangle{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    };
    const Triangle of_a = edges(a), of_b = edges(b);
    if (separates(glm::cross(of_a[0], of_a[1])) || separates(glm::cross(of_b[0], of_b[1])))
        return true;
    for (const Vec3& u : of_a) {
        for (const Vec3& v : of_b) {
            if (separates(glm::cross(u, v))) return true;
        }
    }
    return false;
}

/// Of two meshes of one surface each: if the surfaces stay apart and one point of the inner one is
/// within the outer, all of it is. `to_outer` leads from the world to the outer one's frame.
std::optional<bool> is_mesh_contained(const PlacedShape& placed, const geom::TriangleMesh& inner,
                                      const geom::TriangleMesh& outer,
                                      const geom::Transform& to_outer, double room) {
    if (inner.stats().components != 1 || outer.stats().components != 1) return std::nullopt;
    const auto triangle = [&](std::size_t i) {
        Triangle result = inner.corners(geom::Face(i));
        for (Vec3& p : result) p = to_outer.point(placed.transform().point(p));
        return result;
    };
    // Mostly some point tells soon that it is not.
    constexpr std::size_t few = 64;
    for (std::size_t i = 0; i < few; ++i) {
        if (outer.depth_at(triangle(i * inner.size() / few)[0]) <= 0) return false;
    }
    std::vector<geom::Bounds> boxes(outer.size());
    for (std::size_t i = 0; i < outer.size(); ++i) {
        for (const Vec3& p : outer.corners(geom::Face(i))) boxes[i].extend(p);
    }
    const geom::Bvh hierarchy(boxes);
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const Triangle own = triangle(i);
        geom::Bounds box;
        for (const Vec3& p : own) box.extend(p);
        bool is_near = false;
        hierarchy.overlapping(box.padded(room), [&](std::uint32_t j) {
            is_near = is_near || !are_apart(own, outer.corners(geom::Face(j)), room);
        });
        if (is_near) return std::nullopt;
    }
    return true;
}

}  // namespace

std::optional<bool> is_contained(const PlacedShape& inner, const PlacedShape& outer, double room) {
    const geom::Transform to_outer = outer.transform().inverse();
    const double local_room = room * to_outer.largest_scale();
    if (const auto* around = std::get_if<geom::Mesh>(&outer.shape())) {
        const auto* within = std::get_if<geom::Mesh>(&inner.shape());
        if (!within || room == 0.0) return std::nullopt;
        return is_mesh_contained(inner, *within->triangles, *around->triangles, to_outer,
                                 local_room);
    }
    // Of a mesh the box around it must do where nothing hangs on the answer but time.
    const bool is_boxed = room > 0.0 && std::holds_alternative<geom::Mesh>(inner.shape());
    Rings own;
    if (is_boxed) {
        add_corners(std::get<geom::Mesh>(inner.shape()).bounds(), own);
    } else {
        own = std::visit([](const auto& s) { return rings_of(s); }, inner.shape());
    }
    if (own.empty()) return std::nullopt;
    bool exact = !is_boxed;
    const Rings rings = moved(moved(own, inner.transform(), exact), to_outer, exact);
    return std::visit(
        [&](const auto& shape) -> std::optional<bool> {
            double size = shape.magnitude();
            for (const Ring& ring : rings) size = std::max(size, geom::max_abs(ring.center));
            const double most = room > 0.0 ? -local_room : 16.0 * geom::unit_roundoff * size;
            for (const Ring& ring : rings) {
                const auto out = excess(shape, ring);
                if (!out) return std::nullopt;
                if (!(*out <= most)) return exact ? std::optional(false) : std::nullopt;
            }
            return true;
        },
        outer.shape());
}

double room_to_spare(const RenderScene& scene) {
    double largest = 0.0;
    for (const Part& part : scene.parts) largest = std::max(largest, part.shape.magnitude());
    return 1e-6 * (largest + scene.size) + 1000.0 * scene.contact_tolerance;
}

}  // namespace meniscus::tracer
