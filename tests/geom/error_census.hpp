#pragma once

#include "tests/geom/hard_cases.hpp"
#include "tests/geom/referee.hpp"

namespace meniscus::geom {

/// How far the crossings of `ray` are from the exact ones, along the normal, in units of u M: the
/// longest piece of the line on which the two disagree about being inside, times the smaller |d.n|
/// of its ends; or how deep in the surface that piece lies, if that is less. Pairs that one of them
/// has and the other has not count with their chord. `pin` as in `interval`.
double error_in_units(const PlacedShape& shape, const Referee& referee, const Ray& ray, Face pin);

struct Census {
    double worst = 0.0;  // c: the largest error in units of u M
    Ray ray;             // where it was found
    Shape shape;
    Transform transform;
    int lines = 0, crossings = 0;
};

/// Looks for the worst error among `count` lines on random shapes: aimed anywhere, at corners,
/// along edges, grazing, from far away, and leaving the surface itself.
Census census(Kind kind, Placement placement, int count, unsigned seed);

}  // namespace meniscus::geom
