#pragma once

#include <vector>

#include "inspect/finding.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::inspect {

/// What will go wrong with a scene, found before any ray is traced: in the order of the text. Of
/// findings that say the same of one place in the text (a loop's), the first is kept and counts the
/// others.
std::vector<Finding> check(const tracer::RenderScene& scene);

/// Of these the meshes with holes that were meant as solids, which takes no time to find: said
/// whenever a scene is rendered.
std::vector<Finding> check_open_meshes(const tracer::RenderScene& scene);

}  // namespace meniscus::inspect
