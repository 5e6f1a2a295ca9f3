#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/scene_options.hpp"
#include "tracer/options.hpp"

namespace meniscus::cli {

/// What `bench` is told.
struct BenchOptions {
    std::vector<std::string> scenes;
    SceneOptions scene{
        .scene = {}, .width = 320, .height = 240, .declarations = {}, .library_paths = {}};
    bool quick = false, no_povray = false, clip = false;
    std::vector<std::string> models, modes;
    std::vector<int> samples;
    std::vector<double> aa, errors;
    std::optional<int> runs, reference_samples;
    std::optional<double> gap, scale;
    std::string gap_scene;
    std::vector<std::string> povray_sources;  // MODEL=FILE
    int depth = tracer::Options{}.depth, threads = 1;
    std::string csv, svg, report, json;
};

void add_bench_options(CLI::App& command, BenchOptions& options);

/// The same as a command line, to be told again.
std::string own_command_line(const BenchOptions& options);

}  // namespace meniscus::cli
