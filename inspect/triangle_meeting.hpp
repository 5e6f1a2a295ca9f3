#pragma once

#include <array>
#include <variant>

#include "geom/vec.hpp"

namespace meniscus::inspect {

/// A triangle and the plane it spans.
struct FlatTriangle {
    std::array<geom::Vec3, 3> corners{};
    geom::Vec3 normal{0.0};  // of unit length, or 0 if the corners lie on a line

    double slimness = 0.0;  // by how much the normal turns if a corner moves by a unit

    explicit FlatTriangle(const std::array<geom::Vec3, 3>& corners);
    /// Over the plane; 0 where it is not more than `margin`, or than what a corner that is off by
    /// it makes of the plane at `p`.
    double height(const geom::Vec3& p, double margin) const;
};

/// Where two triangles of unlike planes share more than a point.
struct SharedSegment {
    geom::Vec3 from, to;
    int first_edge, second_edge;  // the edge of each that it runs along, from its corner of that
                                  // number; -1 if it runs within
    double depth;                 // how far the less deep one reaches through the other's plane
};

/// What two triangles of one plane have in common, if that has a width.
struct SharedArea {
    geom::Vec3 center;
    double width;  // twice the area by the perimeter
    bool same_facing;
};

/// How two triangles meet. What is nearer to a plane or an edge than `margin` is taken to lie on
/// it, so that decimal coordinates and rounding do not make a cut of a touch; then all is decided
/// as if in exact numbers. A point in common is no meeting.
using TriangleMeeting = std::variant<std::monostate, SharedSegment, SharedArea>;
TriangleMeeting meet(const FlatTriangle& first, const FlatTriangle& second, double margin);

}  // namespace meniscus::inspect
