#pragma once

#include <string>

#include "cli/scene_options.hpp"
#include "compare/report.hpp"

namespace meniscus::cli {

/// A scene as POV-Ray renders it, the reference, and as Meniscus does, at the same pixel centres.
struct SceneComparison {
    compare::Comparison comparison;
    compare::ReportWords words;  // without title and tolerance; `explanations` only if asked for
};

struct SceneComparisonOptions {
    SceneOptions scene;
    std::string reference;  // what POV-Ray reads; empty: the scene itself
    compare::Settings settings;
    int runs = 1;          // times are the median of so many runs
    bool explain = false;  // add the ray trees of the worst pixels
};

/// Throws what reading a scene and running POV-Ray throw.
SceneComparison compare_scene(const SceneComparisonOptions& options);

}  // namespace meniscus::cli
