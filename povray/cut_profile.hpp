#pragma once

#include <vector>

#include "geom/profile.hpp"

namespace meniscus::povray {

/// The control points of Bezier curves that are the piece, cut at equal steps of its parameter:
/// four a curve, joints twice.
std::vector<geom::Vec2> cut(const geom::ProfilePiece& piece, int curves);

}  // namespace meniscus::povray
