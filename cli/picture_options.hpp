#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/save.hpp"

namespace meniscus::cli {

/// Where a picture goes, and in what form.
struct PictureOptions {
    std::string output;  // empty: the scene's name in the working directory; "-": standard output
    std::string format;  // empty: by the output's extension
    std::optional<int> bits;
    std::string encoding;  // empty: as the scene asks
    bool half = false;
    std::vector<std::string> layers;  // as given: "all" or names
};

void add_picture_options(CLI::App& app, PictureOptions& options);

struct PictureTarget {
    std::filesystem::path path;
    image::SaveOptions save;
    std::vector<std::string> layers;  // each one's own name: no "all"
};

/// `stem` names the picture where the options do not. Throws `UsageError` for forms that do not go
/// together.
PictureTarget make_target(const PictureOptions& options, const std::string& stem);

}  // namespace meniscus::cli
