#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "povray/film.hpp"

namespace meniscus::cli {

/// How solids meet: as the scene says, with films of the outside's medium between them, or without
/// priorities.
struct ModelOptions {
    std::string model = "contact";
    std::optional<double> gap;
};

void add_model_options(CLI::App& app, ModelOptions& options);

/// Throws UsageError for words that do not go together.
void check_usage(const ModelOptions& options);

/// The scene as the model has it. How thick films are goes to standard error, unless `quiet`.
scene::Scene in_model(scene::Scene scene, const ModelOptions& options, bool quiet);

/// How thick the films of the gap model really are: "0.01 to 0.012 scene units thick".
std::string film_text(const std::optional<povray::Thickness>& thickness);

/// The same on standard error.
void print_film(const std::optional<povray::Thickness>& thickness);

}  // namespace meniscus::cli
