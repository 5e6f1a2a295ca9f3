#pragma once

#include <array>
#include <vector>

#include "geom/crossing.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

struct ProfilePiece;

/// A stretch of a profile along which radius and height each only rise or only fall, which bends to
/// one side only, and by no more than half a right angle or so. It is a graph over its chord:
/// `along` is the way from its start, and `rise` how far the curve lies beside the chord there.
struct ProfileArc {
    enum class Kind {
        gap,       // no arc: here one chain of pieces ends and the next begins
        straight,  // its own chord
        bulging,   // on the side of its chord that looks away from the axis
        hollow,    // on the other side
    };

    Kind kind = Kind::gap;
    Face piece = no_face;
    Vec2 start{0.0}, end{0.0};                  // exactly those of the neighbours
    Vec2 chord{0.0}, normal{0.0};               // unit vectors; the normal looks away from the axis
    double length = 0.0;                        // of the chord
    double inner2 = 0.0, outer2 = 0.0;          // squares of the least and the greatest radius
    std::array<double, 3> along{}, rise{};      // coefficients of v, v^2 and v^3, v from 0 to 1
    double slope_start = 0.0, slope_end = 0.0;  // of the rise over the chord
    double least_bend = 0.0, greatest_bend = 0.0;  // bounds of its second derivative's size

    double least_rise = 0.0, greatest_rise = 0.0;
    double start_pace = 1.0, end_pace = 1.0;  // dv / d(s / length), for a first guess of v

    struct Rise {
        double value, slope;
    };
    /// The curve over the point of the chord at `s`; `v` is a first guess of its parameter, which
    /// is improved. Beyond the ends the curve goes on straight.
    Rise rise_at(double s, double& v) const;

    /// Where a point lies over the chord, and how far beside it.
    double way(const Vec2& p) const { return glm::dot(p - start, chord); }
    double height(const Vec2& p) const { return glm::dot(p - start, normal); }
};

/// Cuts a piece into arcs, and drops what lies at negative radii.
void append_arcs(const ProfilePiece& piece, Face index, std::vector<ProfileArc>& out);

}  // namespace meniscus::geom
