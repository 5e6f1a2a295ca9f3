#pragma once

#include "inspect/check.hpp"
#include "tests/inspect/scenes.hpp"

/// What `check` finds in scenes that are plain values.
namespace meniscus::test {

inline std::vector<inspect::Finding> check(const scene::Scene& scene) {
    return inspect::check(tracer::compile(scene));
}

inline scene::Scene seen_from_afar() {
    scene::Scene scene;
    scene.camera.location = {0.0, 0.0, -50.0};
    return scene;
}

using Lints = std::vector<std::string>;

/// The names of the rules that found something.
inline Lints lints(const std::vector<inspect::Finding>& findings) {
    Lints names;
    for (const auto& finding : findings) names.push_back(finding.lint);
    return names;
}

}  // namespace meniscus::test
