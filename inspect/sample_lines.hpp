#pragma once

#include <utility>
#include <vector>

#include "geom/bounds.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::inspect {

/// A part of a line inside a solid, and the faces at its ends.
struct Inside {
    double begin, end;  // may be infinite
    geom::Face first, last;
};

/// Where a line is inside of a closed part's solid, the whole line long, in order.
std::vector<Inside> inside(const tracer::Part& part, const geom::Ray& line);

/// Lines through a box, along each axis; the same ones each time.
std::vector<geom::Ray> sample_lines(const geom::Bounds& box, int lines_per_axis);

/// Pairs of members whose bounds come nearer than `margin` times their size: of different solids,
/// or with `all` also of one.
enum class Pairing { unlike, all };
std::vector<std::pair<int, int>> neighbours(const tracer::RenderScene& scene, double margin,
                                            Pairing pairing = Pairing::unlike);

/// Where two parts can both be: finite, even where they are not.
geom::Bounds common_region(const tracer::RenderScene& scene, const tracer::Part& a,
                           const tracer::Part& b, double margin);

}  // namespace meniscus::inspect
