#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lang/interpret.hpp"

namespace meniscus::cli {

/// Which scene to read, and what its text depends on.
struct SceneOptions {
    std::string scene;  // "-" is standard input
    int width = 640, height = 480;
    std::vector<std::string> declarations;  // NAME=VALUE
    std::vector<std::string> library_paths;
    bool number_triangles = false;  // what a mesh remembers, to name them
    /// Files that will be written: none may be one that is read.
    std::vector<std::string> outputs = {};

    /// "glass.scene" of "scenes/glass.scene"; "stdin" of "-".
    std::string file_name() const;
    /// The file name without its extension.
    std::string stem() const;
};

void add_scene_options(CLI::App& app, SceneOptions& options);
/// The same without the scene itself.
void add_scene_settings(CLI::App& app, SceneOptions& options);

/// Throws UsageError before anything is written if `outputs` has a file that the scene is read
/// from. What #debug and the like print goes to standard error; the warnings are the caller's to
/// print.
lang::Interpreted interpret_scene(const SceneOptions& options);

/// The same; warnings go to standard error.
lang::Interpreted read_scene(const SceneOptions& options);

}  // namespace meniscus::cli
