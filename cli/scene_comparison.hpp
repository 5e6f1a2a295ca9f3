#pragma once

#include <optional>
#include <string>

#include "cli/scene_options.hpp"
#include "compare/report.hpp"
#include "povray/export.hpp"

namespace meniscus::cli {

/// A scene as POV-Ray renders it, the reference, and as Meniscus does, at the same pixel centres.
struct SceneComparison {
    compare::Comparison comparison;
    compare::ReportWords words;  // without title and tolerance; `explanations` only if asked for
};

struct SceneComparisonOptions {
    SceneOptions scene;
    std::string reference;               // a source for POV-Ray; empty: see `model`
    std::optional<povray::Model> model;  // what is exported for it; none: it reads the scene itself
    double gap = 0.0;                    // Model::gap: scene units, for both renderers
    std::optional<double> scale;         // of the export; default: by the scene's size
    compare::Settings settings;
    int runs = 1;          // times are the median of so many runs
    bool explain = false;  // add the ray trees of the worst pixels
};

/// Throws what reading a scene and running POV-Ray throw.
SceneComparison compare_scene(const SceneComparisonOptions& options);

}  // namespace meniscus::cli
