#pragma once

#include <string>

#include "inspect/pixel_trace.hpp"

namespace meniscus::inspect {

/// The ray tree as an SVG picture, seen from the side: the cross-section through the solids, the
/// segments in the colour of their medium, true crossings as filled dots, false ones hollow.
std::string draw_diagram(const tracer::RenderScene& scene, const Names& names,
                         const PixelTrace& trace);

}  // namespace meniscus::inspect
