#pragma once

#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// The faces that two parts' solids have in common with both on the same side, as sample lines
/// find them.
struct Flush {
    std::vector<geom::Vec3> flat;    // their outward unit normals
    std::vector<geom::Face> curved;  // of the first part
};

Flush flush_faces(const tracer::RenderScene& scene, const tracer::Part& a, const tracer::Part& b);

}  // namespace meniscus::povray
