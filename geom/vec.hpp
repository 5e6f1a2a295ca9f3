#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace meniscus::geom {

/// All geometry is double precision. The coordinate system is POV-Ray's, left-handed: x right, y
/// up, z into the picture.
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;  // column-major: m[column][row]

/// Half the distance from 1 to the next double: the relative rounding error of one operation.
inline constexpr double unit_roundoff = 0x1p-53;

/// The largest of the absolute values of the three coordinates.
inline double max_abs(const Vec3& v) {
    const Vec3 a = glm::abs(v);
    return a.x > a.y ? (a.x > a.z ? a.x : a.z) : (a.y > a.z ? a.y : a.z);
}

}  // namespace meniscus::geom
