#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "povray/export.hpp"
#include "tracer/render.hpp"

namespace meniscus::test {

/// What a line at the head of a golden scene says:
///     // expect contact rmse 5e-5, off 0.3 %: why no nearer
///     // expect gap 1e-3 rmse 1e-5, off 0 %: why no nearer
struct Expectation {
    povray::Model model;
    double gap;          // Model::gap alone
    double rmse;         // away from edges
    double percent_off;  // of all pixels, by more than 0.01
    std::string text;    // "contact", "gap 1e-3"
};

/// Those at the head of the file.
std::vector<Expectation> expectations(const std::filesystem::path& scene);

/// The scenes of a folder, by name.
std::vector<std::filesystem::path> golden_scenes(const std::filesystem::path& folder);

/// A scene file, for both renderers: with POV-Ray's indices of refraction.
scene::Scene read_golden(const std::filesystem::path& path, int width, int height);

/// Its export by the expectation's model, and our side of it: the scene, or the scene with films;
/// at pixel centres.
povray::Exported export_golden(const scene::Scene& scene, const Expectation& expectation);
tracer::Rendered render_golden(const scene::Scene& scene, const Expectation& expectation, int width,
                               int height, tracer::Kernel kernel = tracer::Kernel::automatic);

}  // namespace meniscus::test
