#pragma once

#include <optional>

#include "geom/anchor.hpp"
#include "geom/shape.hpp"
#include "geom/transform.hpp"

namespace meniscus::geom {

/// A shape where the scene puts it. All rays, points and normals are in world coordinates, and t is
/// the world ray's.
class PlacedShape {
public:
    /// Takes the transform into the shape's own numbers where that loses nothing that matters (a
    /// moved sphere is a sphere, but for its digits far from the origin).
    PlacedShape(Shape shape, const Transform& transform);

    /// The shape, in the frame from which `transform` leads to the world: the identity if it could
    /// be taken in.
    const Shape& shape() const { return shape_; }
    const Transform& transform() const { return transform_; }
    bool is_closed() const { return closed_; }
    bool is_convex() const { return convex_; }
    const Bounds& bounds() const { return bounds_; }
    /// m_S in world units: the local magnitude under the largest scale, plus twice the largest
    /// shift.
    double magnitude() const { return magnitude_; }
    /// What the shape shares with others about the same centre or axis or in the same frame.
    std::optional<Anchor> anchor() const;

    Interval interval(const Ray& ray, Face pin) const;
    void crossings(const Ray& ray, Crossings& out) const;
    void hits(const Ray& ray, Crossings& out) const;
    void crossings(const Ray& ray, const Search& search, Crossings& out) const;
    bool crossings_ahead(const Ray& ray, const Search& search, std::optional<int> depth,
                         Crossings& out) const;
    /// At the point's exact origin.
    Vec3 normal(Face face, const Ray& point) const;
    Vec3 normal(Face face, const Vec3& p) const { return normal(face, Ray{p}); }
    Vec3 shading_normal(Face face, const Ray& point) const;
    Vec3 shading_normal(Face face, const Vec3& p) const { return shading_normal(face, Ray{p}); }
    /// As the shape's: the way from `point`'s exact origin to the face.
    Vec3 to_face(Face face, const Ray& point) const;
    Vec3 on_face(Face face, const Vec3& p) const { return p + to_face(face, Ray{p}); }
    /// Moves `point`'s exact origin to the face, and returns the normals there.
    struct Normals {
        Vec3 flat, shading;
    };
    Normals put_on_face(Face face, Ray& point) const;
    bool contains(const Vec3& p) const;
    int depth_at(const Vec3& p) const;

private:
    // What rays need most stands first.
    Transform transform_;
    Shape shape_;
    bool closed_, convex_;
    double magnitude_;
    Bounds bounds_;
};

}  // namespace meniscus::geom
