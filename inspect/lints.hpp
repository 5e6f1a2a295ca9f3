#pragma once

#include <vector>

#include "inspect/finding.hpp"
#include "inspect/names.hpp"

namespace meniscus::inspect {

/// A rule: it looks at a scene and tells what it finds.
using Lint = void(const tracer::RenderScene& scene, const Names& names,
                  std::vector<Finding>& findings);

// To add a lint: declare it here, name it in check.cpp, write it beside its relatives.

Lint find_bad_meetings;   // lint_meetings.cpp
Lint find_hidden_solids;  // lint_hidden.cpp
Lint find_buried_solids;  // lint_unseen.cpp
Lint find_thin_solids;
Lint find_open_meshes;  // lint_meshes.cpp
Lint find_repaired_meshes;
Lint find_bad_shells;           // lint_shells.cpp
Lint find_media_without_solid;  // lint_media.cpp
Lint find_hidden_iors;
Lint find_camera_in_media;  // lint_space.cpp
Lint find_camera_in_opaque;
Lint find_lost_sky;
Lint find_buried_lights;

}  // namespace meniscus::inspect
