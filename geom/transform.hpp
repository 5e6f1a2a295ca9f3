#pragma once

#include <memory>

#include "geom/bounds.hpp"
#include "geom/ray.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

/// An affine map p -> linear * p + shift, kept with its inverse. Copies share their numbers, and
/// the identity, which most shapes have, needs none.
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

    bool is_identity() const { return !numbers_; }
    bool is_translation() const { return is_identity() || numbers_->is_translation; }
    const Mat3& linear() const { return numbers().linear; }
    const Mat3& inverse_linear() const { return numbers().inverse_linear; }
    const Vec3& shift() const { return numbers().shift; }

    Vec3 point(const Vec3& p) const { return is_identity() ? p : linear() * p + shift(); }
    Vec3 vector(const Vec3& v) const { return is_identity() ? v : linear() * v; }
    /// A surface normal (by the inverse transpose), not normalised.
    Vec3 normal(const Vec3& n) const { return is_identity() ? n : n * inverse_linear(); }
    /// World to own frame: t stays what it is, so the direction is not normalised.
    Ray to_local(const Ray& ray) const;
    Vec3 to_local(const Vec3& p) const {
        return is_identity() ? p : inverse_linear() * (p - shift());
    }
    Bounds bounds(const Bounds& local) const;
    /// The largest factor by which a length grows.
    double largest_scale() const { return numbers().largest_scale; }

private:
    struct Numbers {
        Mat3 linear{1.0}, inverse_linear{1.0};
        Vec3 shift{0.0};
        double largest_scale = 1.0;
        bool is_translation = true;  // linear is exactly 1
    };
    static const Numbers identity;

    const Numbers& numbers() const { return numbers_ ? *numbers_ : identity; }

    std::shared_ptr<const Numbers> numbers_;  // null: the identity
};

}  // namespace meniscus::geom
