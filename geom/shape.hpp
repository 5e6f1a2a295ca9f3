#pragma once

#include <optional>
#include <variant>

#include "geom/bounds.hpp"
#include "geom/box.hpp"
#include "geom/cone.hpp"
#include "geom/crossing.hpp"
#include "geom/cylinder.hpp"
#include "geom/disc.hpp"
#include "geom/lathe.hpp"
#include "geom/mesh.hpp"
#include "geom/plane.hpp"
#include "geom/polygon.hpp"
#include "geom/primitive.hpp"
#include "geom/ray.hpp"
#include "geom/sphere.hpp"
#include "geom/torus.hpp"
#include "geom/triangle.hpp"

namespace meniscus::geom {

template <Primitive... Primitives>
using OneOf = std::variant<Primitives...>;

/// To add a primitive: write its struct in a file of its own, name it here, and read
/// docs/adding-a-primitive.md.
using Shape =
    OneOf<Box, Cone, Cylinder, Disc, Lathe, Mesh, Plane, Polygon, Sphere, Torus, Triangle>;

/// The scene language's word for the shape, as "sphere".
std::string_view keyword(const Shape& shape);

/// Whether the shape bounds a volume, so that a ray can be inside it. Open ones are surfaces only.
bool is_closed(const Shape& shape);
/// Whether a line meets the closed shape in one interval at most: `interval` may be asked.
bool is_convex(const Shape& shape);
Bounds bounds(const Shape& shape);
/// The largest absolute coordinate that enters the shape's arithmetic: m_S of the error bound
/// |error of t| |d.n| <= c u M.
double magnitude(const Shape& shape);

/// For convex shapes: the interval on the ray's whole line. `pin` names the face that the ray's
/// origin lies on, if any: that face's root is exactly 0.
Interval interval(const Shape& shape, const Ray& ray, Face pin);
/// For closed shapes: every crossing on the ray's whole line (t of any sign), sorted. Entering and
/// leaving balance, and take turns except where a mesh overlaps itself.
void crossings(const Shape& shape, const Ray& ray, Crossings& out);
/// For open shapes: every meeting on the ray's whole line, sorted; `entering` is set where
/// direction and normal oppose.
void hits(const Shape& shape, const Ray& ray, Crossings& out);

/// At least those crossings, or hits of an open shape, that a search wants, sorted. A large mesh
/// has them sooner than those of the whole line.
void crossings(const Shape& shape, const Ray& ray, const Search& search, Crossings& out);
/// For closed shapes: as TriangleMesh::crossings_ahead. False for every shape but a mesh.
bool crossings_ahead(const Shape& shape, const Ray& ray, const Search& search,
                     std::optional<int> depth, Crossings& out);

/// The outward unit normal of a face at a point of it, by the point's exact origin.
Vec3 normal(const Shape& shape, Face face, const Ray& point);
/// The normal to shade with: interpolated on smooth triangles, else the same. Unit length.
Vec3 shading_normal(const Shape& shape, Face face, const Ray& point);
/// The way from `point`'s exact origin to the nearest point of the face, of which it is within
/// rounding. Its digits begin where those of the origin end.
Vec3 to_face(const Shape& shape, Face face, const Ray& point);
/// The point of the face nearest to `p`, which is within rounding of it.
Vec3 on_face(const Shape& shape, Face face, const Vec3& p);
/// For closed shapes: whether `p` is strictly inside. For a mesh: whether its winding count is
/// positive.
bool contains(const Shape& shape, const Vec3& p);
/// For closed shapes: how many times `p` is inside, by counting; 0 or 1 except for self-overlapping
/// meshes.
int depth_at(const Shape& shape, const Vec3& p);

}  // namespace meniscus::geom
