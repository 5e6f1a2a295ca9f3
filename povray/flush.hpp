#pragma once

#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// Outward unit normals of the flat faces that two parts' solids have in common with both on the
/// same side, as sample lines find them.
std::vector<geom::Vec3> flush_normals(const tracer::RenderScene& scene, const tracer::Part& a,
                                      const tracer::Part& b);

}  // namespace meniscus::povray
