#pragma once

#include "geom/inline_vector.hpp"
#include "geom/lathe_line.hpp"
#include "geom/profile.hpp"

namespace meniscus::geom {

/// A place where a line crosses a turned profile.
struct LatheRoot {
    double t;  // of the line
    Face piece;
};
using LatheRoots = InlineVector<LatheRoot, 16>;

/// Appends the crossings of a whole line with a turned profile, unsorted. With a closed profile
/// their number is even, whatever is rounded: at each joint of arcs one comparison, of the line's
/// and the joint's radius at the joint's height, says on which side of it the line passes, and an
/// arc is crossed an odd number of times where that differs at its two ends (docs/numerics.md).
void append_roots(const LatheLine& line, const Profile& profile, LatheRoots& out);

}  // namespace meniscus::geom
