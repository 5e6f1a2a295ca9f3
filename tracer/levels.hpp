#pragma once

#include <vector>

#include "geom/shape.hpp"

namespace meniscus::tracer {

/// A surface as one of a family that lie at one distance from each other everywhere: planes of one
/// normal, cylinders or like cones about one axis, spheres about one centre.
struct Level {
    enum class Kind { planes, round, spheres, rings, radii, heights };
    Kind kind;
    // What the family has in common.
    geom::Vec3 point, direction;
    double a, b;  // the slope of cones
    double at;    // the distance from the point, or along the direction
};

/// Appends the levels of a shape's surface, its numbers counted from `origin`. A curved lathe has
/// those of its points; meshes have none.
void add_levels(const geom::Shape& shape, const geom::Vec3& origin, std::vector<Level>& levels);

/// Whether two of a family lie nearer to each other than `film`, but not within `rounding`; all
/// numbers are at most of `size`.
bool has_film(const std::vector<Level>& levels, double size, double rounding, double film);

}  // namespace meniscus::tracer
