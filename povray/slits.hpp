#pragma once

#include <string>
#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// Where the scene's contact_tolerance makes one surface of two of different solids: POV-Ray is
/// given both, with a film between. `least`: of narrower ones the export makes contact itself;
/// scene units.
std::vector<std::string> slit_warnings(const tracer::RenderScene& scene, double least);

}  // namespace meniscus::povray
