#pragma once

#include <string>

#include "geom/lathe.hpp"

namespace meniscus::povray {

/// What stands in a lathe's block: the spline and its points. A curved profile is written as Bezier
/// curves, cut short: POV-Ray finds a root to a fixed part of the curve that it is on, and where
/// that is coarser than the 1e-4 of its units nearer than which it sees no hit, light that leaves a
/// face meets it once more.
std::string lathe_head(const geom::Lathe& lathe);

}  // namespace meniscus::povray
