#pragma once

#include "scene/scene.hpp"

namespace meniscus::tracer {

/// No surface and no sky of the scene sends more light than this along a ray of its own, in any
/// channel: a bound, not an estimate. Mirrors that amplify are left out.
double brightest(const scene::Scene& scene);

}  // namespace meniscus::tracer
