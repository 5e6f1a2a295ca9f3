#pragma once

#include <cstddef>

#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

/// Takes out the parts that lie wholly inside of stronger ones, with room to spare, so that no ray
/// sees anything of them; returns how many. Only where that is certain (`is_contained`). `scene`'s
/// parts, hierarchy and size are complete; the hierarchy is no longer right if there are any.
std::size_t leave_out_hidden(RenderScene& scene);

}  // namespace meniscus::tracer
