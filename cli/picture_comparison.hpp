#pragma once

#include <string>

#include "cli/scene_comparison.hpp"

namespace meniscus::cli {

/// Two picture files, the first the reference. Throws what reading them throws.
SceneComparison compare_pictures(const std::string& first, const std::string& second,
                                 const compare::Settings& settings);

}  // namespace meniscus::cli
