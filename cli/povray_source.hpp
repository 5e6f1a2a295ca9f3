#pragma once

#include "cli/scene_options.hpp"
#include "povray/run.hpp"

namespace meniscus::cli {

/// How POV-Ray is to render a source of its own beside a scene: of the same size, with the same
/// declarations and library paths.
povray::RunOptions run_options(const SceneOptions& options);

}  // namespace meniscus::cli
