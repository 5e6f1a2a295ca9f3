#pragma once

#include <cmath>
#include <optional>

#include "geom/vec.hpp"

namespace meniscus::tracer {

/// Exact unpolarised Fresnel reflectance. `eta` is n1 / n2, the ray coming from medium 1; `cosine`
/// is that of the angle of incidence, in [0, 1]. 1 at total reflection. (Born and Wolf, Principles
/// of Optics, section 1.5.)
inline double fresnel_reflectance(double eta, double cosine) {
    const double k =
        1.0 - eta * eta * (1.0 - cosine * cosine);  // squared cosine of the refracted angle
    if (k <= 0.0) return 1.0;
    const double refracted = std::sqrt(k);
    const double s = (eta * cosine - refracted) / (eta * cosine + refracted);
    const double p = (eta * refracted - cosine) / (eta * refracted + cosine);
    return 0.5 * (s * s + p * p);
}

/// The mirrored direction, unit length. `normal` is a unit vector of either sign.
inline geom::Vec3 reflect(const geom::Vec3& direction, const geom::Vec3& normal) {
    return glm::normalize(direction - 2.0 * glm::dot(direction, normal) * normal);
}

/// Snell's law: the direction behind the surface, unit length, or nothing at total reflection.
/// `normal` faces the ray.
inline std::optional<geom::Vec3> refract(const geom::Vec3& direction, const geom::Vec3& normal,
                                         double eta) {
    const double cosine = -glm::dot(direction, normal);
    const double k = 1.0 - eta * eta * (1.0 - cosine * cosine);
    if (k < 0.0) return std::nullopt;
    return glm::normalize(eta * direction + (eta * cosine - std::sqrt(k)) * normal);
}

}  // namespace meniscus::tracer
