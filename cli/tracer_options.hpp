#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/scene_options.hpp"
#include "tracer/options.hpp"

namespace meniscus::cli {

/// What the command line says of the way a picture is traced.
struct TracerOptions {
    std::optional<int> samples, grid;
    std::optional<double> error, seconds, contrast;
    int contrast_depth = 3, contrast_method = 1;
    std::vector<int> region;                                             // empty, or x0 y0 x1 y1
    std::optional<double> start_column, start_row, end_column, end_row;  // POV-Ray's region
    std::string tree;  // empty: implied by the sampling
    std::string interior = "sweep";
    std::string kernel = "automatic";
    std::optional<int> depth;
    std::optional<double> cutoff;  // of --tree full
    std::string filter{tracer::name(tracer::Options{}.filter)};
    std::uint64_t seed = 0;
    int threads = 0;
};

/// Of `--interior`. Throws `UsageError` for other names.
tracer::InteriorMode interior_mode(std::string_view name);

void add_tracer_options(CLI::App& app, TracerOptions& options);

/// Throws `UsageError` for what CLI11 cannot know to be wrong.
tracer::Options make_tracer_options(const TracerOptions& options, const SceneOptions& scene);

/// The options that change the picture, spelled as on the command line; the same text for the same
/// picture.
std::string canonical_options(const tracer::Options& options);

}  // namespace meniscus::cli
