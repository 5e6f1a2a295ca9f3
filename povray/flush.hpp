#pragma once

#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// The faces that two parts' solids have in common with both on the same side, as sample lines
/// find them.
struct Flush {
    std::vector<geom::Vec3> flat;  // outward unit normals of the flat ones
    bool curved = false;           // some are
};

Flush flush_faces(const tracer::RenderScene& scene, const tracer::Part& a, const tracer::Part& b);

}  // namespace meniscus::povray
