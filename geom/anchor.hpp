#pragma once

#include "geom/crossing.hpp"
#include "geom/transform.hpp"

namespace meniscus::geom {

/// How many of its own sizes a solid may lie from the origin before rounding its coordinates there
/// costs digits that are missed: a point then needs a second vector, a solid a frame of its own.
inline constexpr double far_from_origin = 1e4;

/// What a face's arithmetic is relative to. Crossings of two faces with the same anchor differ by
/// rounding as if the origin of coordinates lay there, however far away it is.
struct Anchor {
    enum class Kind {
        center,  // spheres about one point
        axis,    // the sides of cylinders and cones about one axis
        frame    // shapes under one transform: they meet the same local ray
    };
    Kind kind;
    Vec3 point;            // in the world
    Vec3 direction{0.0};   // of an axis, unit length
    Transform frame = {};  // of a frame
    double size;           // how far from the point the shape reaches, in world units
    Face face = no_face;   // the only face that it holds for; `no_face` means all
};

}  // namespace meniscus::geom
