#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/scene_options.hpp"
#include "compare/comparison.hpp"

namespace meniscus::cli {

/// What `compare` was told.
struct CompareOptions {
    std::vector<std::string> inputs;  // two pictures, or scenes
    SceneOptions scene{
        .scene = {}, .width = 320, .height = 240, .declarations = {}, .library_paths = {}};
    std::string povray_source, model;
    std::optional<double> gap, scale;
    compare::Settings settings;
    std::optional<double> tolerance;
    int runs = 1;
    std::string output, report, json;
    std::string sweep, csv, svg, markdown;
};

/// The files that it writes, some of them empty names.
std::vector<std::string> outputs(const CompareOptions& options);

bool is_picture(const std::string& path);

/// Throws UsageError for words that do not go together, and FileError for what cannot be written.
void check_usage(const CompareOptions& options);

/// The same words again, to be typed in a shell, for the comparison of `inputs` alone.
std::string own_command_line(const CompareOptions& options, const std::vector<std::string>& inputs);

}  // namespace meniscus::cli
