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

/// How two solids meet, as found along sample lines.
struct Meeting {
    std::optional<geom::Vec3> shared;  // a point well inside both: touching is not enough
    std::vector<Gap> gaps;             // too thin to be meant, too wide to be rounding
};

/// Solids this near to each other, relative to their coordinates, are taken for a mistake.
inline constexpr double thin = 1e-7;

Meeting meet(const tracer::RenderScene& scene, const tracer::Part& a, const tracer::Part& b,
             int lines_per_axis);

}  // namespace meniscus::inspect
