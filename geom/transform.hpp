#pragma once

#include "geom/bounds.hpp"
#include "geom/ray.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

/// An affine map p -> linear * p + shift, kept with its inverse.
class Transform {
public:
    Transform() = default;  // the identity
    /// `linear` must be invertible: throws std::invalid_argument otherwise.
    Transform(const Mat3& linear, const Vec3& shift);

    static Transform translation(const Vec3& shift);
    static Transform scaling(const Vec3& factors);
    /// POV-Ray's `rotate`: degrees about x, then y, then z; positive turns y to z, z to x, x to y
    /// (left-handed).
    static Transform rotation_degrees(const Vec3& angles);

    /// First this map, then `next`: the order in which scene files write them.
    Transform then(const Transform& next) const;
    Transform inverse() const;

    bool is_identity() const { return identity_; }
    bool is_translation() const { return translation_; }
    const Mat3& linear() const { return linear_; }
    const Mat3& inverse_linear() const { return inverse_linear_; }
    const Vec3& shift() const { return shift_; }

    Vec3 point(const Vec3& p) const { return identity_ ? p : linear_ * p + shift_; }
    Vec3 vector(const Vec3& v) const { return identity_ ? v : linear_ * v; }
    /// A surface normal (by the inverse transpose), not normalised.
    Vec3 normal(const Vec3& n) const { return identity_ ? n : n * inverse_linear_; }
    /// World to own frame: t stays what it is, so the direction is not normalised.
    Ray to_local(const Ray& ray) const;
    Vec3 to_local(const Vec3& p) const { return identity_ ? p : inverse_linear_ * (p - shift_); }
    Bounds bounds(const Bounds& local) const;
    /// The largest factor by which a length grows.
    double largest_scale() const { return largest_scale_; }

private:
    Mat3 linear_{1.0}, inverse_linear_{1.0};
    Vec3 shift_{0.0};
    double largest_scale_ = 1.0;
    bool translation_ = true;  // linear_ is exactly 1
    bool identity_ = true;
};

}  // namespace meniscus::geom
