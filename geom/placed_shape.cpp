#include "geom/placed_shape.hpp"

#include <optional>
#include <utility>

#include "geom/cylindrical.hpp"

namespace meniscus::geom {

namespace {

/// The factor by which a similarity scales: nothing if the map is not one.
std::optional<double> similarity_scale(const Mat3& m) {
    const double tolerance = 8.0 * unit_roundoff;
    const double xx = glm::dot(m[0], m[0]), yy = glm::dot(m[1], m[1]), zz = glm::dot(m[2], m[2]);
    const double skew =
        glm::max(glm::abs(glm::dot(m[0], m[1])),
                 glm::max(glm::abs(glm::dot(m[1], m[2])), glm::abs(glm::dot(m[2], m[0]))));
    if (glm::abs(yy - xx) > tolerance * xx || glm::abs(zz - xx) > tolerance * xx ||
        skew > tolerance * xx) {
        return std::nullopt;
    }
    // A rotation's 0.9999999999999999 means 1.
    return glm::abs(xx - 1.0) <= tolerance ? 1.0 : glm::sqrt(xx);
}

/// Whether each axis is taken to an axis.
bool keeps_axes(const Mat3& m) {
    for (int i = 0; i < 3; ++i) {
        if ((m[i].x != 0.0) + (m[i].y != 0.0) + (m[i].z != 0.0) != 1) return false;
    }
    return true;
}

/// Whether the point moves without rounding.
bool moves_exactly(const Transform& transform, const Vec3& p) {
    return transform.to_local(Ray{transform.point(p)}).from(p) == Vec3{0.0} &&
           transform.is_translation();
}

/// Whether a shape of this size that moves to `center` keeps the digits of its coordinates.
bool keeps_digits(const Vec3& center, double size) {
    return max_abs(center) <= far_from_origin * size;
}

// Each returns whether it could take the transform into the shape's own numbers.

bool take_in(Sphere& sphere, const Transform& transform) {
    const auto scale = similarity_scale(transform.linear());
    if (!scale) return false;
    if (!keeps_digits(transform.point(sphere.center), sphere.radius * *scale) &&
        !moves_exactly(transform, sphere.center))
        return false;
    sphere.center = transform.point(sphere.center);
    sphere.radius *= *scale;
    return true;
}

bool take_in(Box& box, const Transform& transform) {
    if (!keeps_axes(transform.linear())) return false;
    const Vec3 corner1 = transform.point(box.corner1), corner2 = transform.point(box.corner2);
    const Vec3 size = glm::abs(corner2 - corner1);
    if (!keeps_digits(glm::max(glm::abs(corner1), glm::abs(corner2)),
                      glm::min(size.x, glm::min(size.y, size.z))) &&
        !(moves_exactly(transform, box.corner1) && moves_exactly(transform, box.corner2)))
        return false;
    box.corner1 = corner1;
    box.corner2 = corner2;
    return true;
}

bool take_in(Plane& plane, const Transform& transform) {
    const Vec3 n = plane.normal(0, Vec3{0.0});
    const Vec3 anchor = transform.point(plane.distance * n);
    plane.direction = glm::normalize(transform.normal(n));
    plane.distance = glm::dot(anchor, plane.direction);
    return true;
}

bool take_in(Triangle& triangle, const Transform& transform) {
    for (Vec3 Triangle::*corner : {&Triangle::a, &Triangle::b, &Triangle::c}) {
        triangle.*corner = transform.point(triangle.*corner);
    }
    for (Vec3 Triangle::*normal : {&Triangle::na, &Triangle::nb, &Triangle::nc}) {
        triangle.*normal = transform.normal(triangle.*normal);
    }
    if (glm::determinant(transform.linear()) < 0.0) {
        std::swap(triangle.b, triangle.c);
        std::swap(triangle.nb, triangle.nc);
    }
    return true;
}

/// Cylinders and cones: their axis must not turn by a rounding error, or coaxial ones would no
/// longer be so.
template <class Round>
requires requires(Round r) { r.base, r.cap; }
bool take_in(Round& shape, const Transform& transform) {
    if (!moves_exactly(transform, shape.base) || !moves_exactly(transform, shape.cap)) return false;
    shape.base = transform.point(shape.base);
    shape.cap = transform.point(shape.cap);
    return true;
}

bool take_in(Disc& disc, const Transform& transform) {
    if (!moves_exactly(transform, disc.center)) return false;
    disc.center = transform.point(disc.center);
    return true;
}

/// Those that stay in their own frame: about the y axis, or shared.
template <class Other>
bool take_in(Other&, const Transform&) {
    return false;
}

std::optional<Anchor> own_anchor(const Sphere& sphere) {
    return Anchor{.kind = Anchor::Kind::center, .point = sphere.center, .size = sphere.radius};
}

template <class Round>
requires requires(Round r) { r.base, r.cap; }
std::optional<Anchor> own_anchor(const Round& shape) {
    const Axis axis(shape.base, shape.cap);
    double radius = 0.0;
    if constexpr (requires { shape.radius; }) {
        radius = shape.radius;
    } else {
        radius = glm::max(shape.base_radius, shape.cap_radius);
    }
    return Anchor{.kind = Anchor::Kind::axis,
                  .point = axis.base,
                  .direction = axis.direction,
                  .size = axis.length + radius,
                  .face = Round::side_face};
}

/// Those whose numbers are coordinates: they share nothing but the origin.
template <class Other>
std::optional<Anchor> own_anchor(const Other&) {
    return std::nullopt;
}

Shape taken_in(Shape shape, Transform& transform) {
    if (transform.is_identity()) return shape;
    if (std::visit([&](auto& s) { return take_in(s, transform); }, shape)) transform = Transform{};
    return shape;
}

/// What the shift adds to the magnitude of a shape that has taken its place in. The others' numbers
/// hold it already; a plane's distance knows nothing of a shift along the plane, but the rounding
/// of its normal moves the points there by as much as any.
double hidden_shift(const Shape& shape, const Transform& transform) {
    const auto* plane = std::get_if<Plane>(&shape);
    if (!plane) return 0.0;
    // An untouched normal's zeros are exact.
    return transform.is_translation()
               ? glm::dot(glm::abs(plane->normal(0, Vec3{0.0})), glm::abs(transform.shift()))
               : 2.0 * max_abs(transform.shift());
}

}  // namespace

PlacedShape::PlacedShape(Shape shape, const Transform& transform)
    : transform_(transform),
      shape_(taken_in(std::move(shape), transform_)),
      closed_(geom::is_closed(shape_)),
      convex_(geom::is_convex(shape_)),
      magnitude_(geom::magnitude(shape_)),
      bounds_(transform_.bounds(geom::bounds(shape_))) {
    if (transform_.is_identity()) {
        magnitude_ += hidden_shift(shape_, transform);
    } else {
        magnitude_ = magnitude_ * transform_.largest_scale() + 2.0 * max_abs(transform_.shift());
    }
}

std::optional<Anchor> PlacedShape::anchor() const {
    if (!transform_.is_identity()) {
        return Anchor{.kind = Anchor::Kind::frame,
                      .point = transform_.shift(),
                      .frame = transform_,
                      .size = geom::magnitude(shape_) * transform_.largest_scale()};
    }
    return std::visit([](const auto& s) { return own_anchor(s); }, shape_);
}

Interval PlacedShape::interval(const Ray& ray, Face pin) const {
    if (transform_.is_identity()) return geom::interval(shape_, ray, pin);
    return geom::interval(shape_, transform_.to_local(ray), pin);
}

void PlacedShape::crossings(const Ray& ray, Crossings& out) const {
    if (transform_.is_identity()) return geom::crossings(shape_, ray, out);
    geom::crossings(shape_, transform_.to_local(ray), out);
}

void PlacedShape::hits(const Ray& ray, Crossings& out) const {
    if (transform_.is_identity()) return geom::hits(shape_, ray, out);
    geom::hits(shape_, transform_.to_local(ray), out);
}

void PlacedShape::crossings(const Ray& ray, const Search& search, Crossings& out) const {
    geom::crossings(shape_, transform_.to_local(ray), search, out);
}

bool PlacedShape::crossings_ahead(const Ray& ray, const Search& search, std::optional<int> depth,
                                  Crossings& out) const {
    return geom::crossings_ahead(shape_, transform_.to_local(ray), search, depth, out);
}

Vec3 PlacedShape::normal(Face face, const Ray& point) const {
    if (transform_.is_identity()) return geom::normal(shape_, face, point);
    return glm::normalize(
        transform_.normal(geom::normal(shape_, face, transform_.to_local(point))));
}

Vec3 PlacedShape::shading_normal(Face face, const Ray& point) const {
    if (transform_.is_identity()) return geom::shading_normal(shape_, face, point);
    return glm::normalize(
        transform_.normal(geom::shading_normal(shape_, face, transform_.to_local(point))));
}

Vec3 PlacedShape::to_face(Face face, const Ray& point) const {
    if (transform_.is_identity()) return geom::to_face(shape_, face, point);
    return transform_.vector(geom::to_face(shape_, face, transform_.to_local(point)));
}

PlacedShape::Normals PlacedShape::put_on_face(Face face, Ray& point) const {
    if (const auto* mesh = std::get_if<Mesh>(&shape_)) {
        // A triangle is looked up once for all.
        const TriangleMesh::FacePlane plane = mesh->triangles->plane(face);
        const Vec3 way = to_plane(transform_.to_local(point).from(plane.corner), plane.normal);
        point.origin_error += transform_.vector(way);
        const Vec3 flat = transform_.is_identity()
                              ? plane.normal
                              : glm::normalize(transform_.normal(plane.normal));
        return {flat, mesh->triangles->is_smooth() ? shading_normal(face, point) : flat};
    }
    point.origin_error += to_face(face, point);
    const Vec3 flat = normal(face, point);
    return {flat, std::holds_alternative<Triangle>(shape_) ? shading_normal(face, point) : flat};
}

bool PlacedShape::contains(const Vec3& p) const {
    return geom::contains(shape_, transform_.to_local(p));
}

int PlacedShape::depth_at(const Vec3& p) const {
    return geom::depth_at(shape_, transform_.to_local(p));
}

}  // namespace meniscus::geom
