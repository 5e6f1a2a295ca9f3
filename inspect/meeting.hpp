#pragma once

#include <optional>
#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::inspect {

/// A slit between two solids: how wide, along the normal, and where.
struct Gap {
    double width;
    geom::Vec3 position;
};

/// What two solids share: a point well inside both, and how thick the overlap is there, in the
/// thinnest of a few directions.
struct Overlap {
    geom::Vec3 position;
    double depth;
};

/// How two solids meet, as found along sample lines.
struct Meeting {
    std::optional<Overlap> overlap;  // the deepest found; touching is not enough
    // Too thin to be meant, too wide to be rounding:
    std::vector<Gap> gaps;   // between the two
    std::vector<Gap> films;  // of the one of lower priority, outside a surface of the other
};

/// Solids this near to each other, relative to their coordinates, are taken for a mistake.
inline constexpr double thin = 1e-7;

/// Lines on which a gap or film must be seen: a round solid that touches another is that near to it
/// on hardly any.
inline constexpr std::size_t fewest_slits = 3;

/// Whether a width (scene units, along the normal) is too thin to be meant and too wide for
/// rounding, where coordinates are of that magnitude.
bool is_thin(const tracer::RenderScene& scene, double width, double magnitude);

Meeting meet(const tracer::RenderScene& scene, const tracer::Part& a, const tracer::Part& b,
             int lines_per_axis);

/// The same with gaps and films up to `widest` (scene units) in place of `thin`, whatever contact
/// tolerance the scene states.
Meeting meet_within(const tracer::RenderScene& scene, const tracer::Part& a, const tracer::Part& b,
                    int lines_per_axis, double widest);

}  // namespace meniscus::inspect
