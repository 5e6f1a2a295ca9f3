#pragma once

#include <string>
#include <variant>

#include "lanes/program.hpp"
#include "tracer/options.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

/// Why lanes cannot follow a scene's rays.
struct NoLanes {
    std::string reason;
};

/// The scene as the kernel for lanes needs it (docs/kernels.md), or why it cannot have it: then
/// rays go one at a time.
std::variant<lanes::Program, NoLanes> make_lane_program(const RenderScene& scene,
                                                        const Options& options);

}  // namespace meniscus::tracer
