#pragma once

#include <optional>
#include <string_view>

#include "geom/placed_shape.hpp"
#include "tests/geom/lines.hpp"

namespace meniscus::geom {

/// The kinds of closed shapes that obey the law of errors, and how they can be placed.
enum class Kind {
    box,
    cone,
    cylinder,
    plane,
    sphere,
    torus,
    lathe_linear,
    lathe_quadratic,
    lathe_cubic,
    lathe_bezier
};
inline constexpr Kind all_kinds[] = {
    Kind::box,   Kind::cone,         Kind::cylinder,        Kind::plane,       Kind::sphere,
    Kind::torus, Kind::lathe_linear, Kind::lathe_quadratic, Kind::lathe_cubic, Kind::lathe_bezier};

enum class Placement {
    as_it_is,  // near its own origin or up to 1e6 of its sizes away
    moved,     // turned, scaled alike in all directions, shifted by up to 1e6 sizes
    scaled,    // by factors up to 10 : 1, then turned and shifted
    sheared,   // turned, scaled up to 30 : 1, turned and shifted
};
inline constexpr Placement all_placements[] = {Placement::as_it_is, Placement::moved,
                                               Placement::scaled, Placement::sheared};

std::string_view name(Kind kind);
std::string_view name(Placement placement);

/// A shape 1e-6 to 1e6 in size, of up to 1e4 : 1 in its proportions, and a few lines of code's
/// worth of bad luck: equal radii, points, axes along axes.
Shape random_shape(Kind kind, Dice& dice);
Transform random_transform(Placement placement, double size, Dice& dice);

/// A point that a line may well be aimed at: within the shape's bounds, in their corners, on the
/// middles of their edges and sides.
Vec3 random_target(const Bounds& local, const Transform& transform, Dice& dice);
/// The bounds, or for a half-space those of a cube about the foot of its normal.
Bounds finite_bounds(const Shape& shape);

/// A line that passes `p` at a slope of 0 to 1 against the normal: grazing by any degree.
Vec3 direction_at(const Vec3& normal, Dice& dice);
/// 10 to the power of a number between the two.
double log_uniform(double low_decade, double high_decade, Dice& dice);

}  // namespace meniscus::geom
