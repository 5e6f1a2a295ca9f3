#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace meniscus::oracle {

struct SegmentCheck {
    std::uint64_t segments = 0;  // that were checked
    std::uint64_t wrong = 0;     // whose list has another solid on top than the point is in
    std::uint64_t leaks = 0;     // that the tracer counted itself
    std::uint64_t after_leak = 0, wrong_after_leak = 0;  // of both, those of a walk from its first
                                                         // leak on
};

/// Follows random walks of rays through the scene, at each surface by reflection or refraction, and
/// asks in quad precision which solid is at a random point of each segment. Points nearer than 1e-9
/// of the scene's size to a surface may be on either side of it.
SegmentCheck check_segments(const scene::Scene& scene, std::uint64_t seed, std::uint64_t segments);

}  // namespace meniscus::oracle
