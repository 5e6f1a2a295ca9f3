#pragma once

#include "scene/scene.hpp"

namespace meniscus::povray {

/// POV-Ray follows no deeper tree of rays, and warns of a scene that asks for one.
inline constexpr int most_trace_levels = 256;

/// The scene with the indices of refraction that POV-Ray 3.7 makes of them: relative to the
/// outside's, in single precision (measured: with 1.33 as 1.3300000429 a picture of nested spheres
/// agrees in all pixels, else light that leaves them level meets other squares of a far floor).
scene::Scene with_povrays_iors(scene::Scene scene);

}  // namespace meniscus::povray
