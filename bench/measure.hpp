#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "bench/result.hpp"
#include "bench/sweep.hpp"
#include "povray/run.hpp"
#include "scene/scene.hpp"

namespace meniscus::bench {

/// A source of its own for POV-Ray: it must take its limits from the declared MTL and ADC.
struct PovRaySource {
    std::filesystem::path file;
    std::vector<std::pair<std::string, std::string>> declares;
    std::vector<std::filesystem::path> library_paths;
};

/// What is measured, and how.
struct Setup {
    std::string name;  // of the scene
    scene::Scene scene;
    std::optional<scene::Scene> gap_scene;  // of the gap model; else the scene with films
    int width = 320, height = 240, threads = 1;
    int runs = 3;       // rounds; each time is their median. Short ones are repeated in a round
    double gap = 1e-4;  // of the gap model, scene units
    std::optional<double> scale;  // of what is exported to POV-Ray; default: by the scene's size
    int reference_samples = 256;  // of each half
    bool clip = false;            // beside POV-Ray pictures are clipped in any case
    Sweep sweep;
    std::map<Model, PovRaySource> povray_sources;

    std::function<void(const std::string&)> say;     // a line about what goes on
    const std::atomic<bool>* interrupted = nullptr;  // set: keep what is measured
};

/// Throws what measuring this model would, as far as that can be known without rendering.
void check(const Setup& setup, Model model);

/// Throws what exporting a scene throws, and povray::NotInstalled; a scene that POV-Ray does not
/// render is a row with its words.
Result measure(const Setup& setup);

}  // namespace meniscus::bench
