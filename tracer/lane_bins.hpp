#pragma once

#include "lanes/program.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

/// In which bins the program's rays wait, and what those of each may come to. The program's solids
/// and members are complete.
void make_bins(const RenderScene& scene, lanes::Program& program);

}  // namespace meniscus::tracer
