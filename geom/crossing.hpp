#pragma once

#include <cstdint>
#include <limits>

#include "geom/inline_vector.hpp"

namespace meniscus::geom {

/// Which part of a shape's surface: a cap or the side, a box's side, a triangle of a mesh, a piece
/// of a profile.
using Face = std::int32_t;
inline constexpr Face no_face = -1;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a line passes through a surface, at origin + t * direction, and whether it enters the
/// solid there or leaves it.
struct Crossing {
    double t;
    Face face;
    bool entering;
};

/// The crossings of a whole line with one shape, sorted by t.
using Crossings = InlineVector<Crossing, 8>;

/// What a convex solid leaves of a line: [t0, t1], entered through face0 and left through face1;
/// infinite ends belong to half-spaces. Where the line misses (`hit` is false), t1 and face1 still
/// say where a ray that is known to start inside leaves: they never depend on t0.
struct Interval {
    double t0 = infinity, t1 = -infinity;
    Face face0 = no_face, face1 = no_face;
    bool hit = false;
};

}  // namespace meniscus::geom
