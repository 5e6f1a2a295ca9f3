#include "cli/model_options.hpp"

#include <fmt/format.h>

#include "cli/exit_code.hpp"
#include "cli/validators.hpp"
#include "povray/plain.hpp"

namespace meniscus::cli {

void add_model_options(CLI::App& app, ModelOptions& options) {
    app.add_option("--model", options.model,
                   "contact: solids as the scene says; gap: with films of the outside's medium "
                   "where one cuts another, as a gap in POV-Ray is; plain: without priorities, the "
                   "solid entered last is there")
        ->check(CLI::IsMember({"contact", "gap", "plain"}))
        ->type_name("MODEL")
        ->capture_default_str();
    app.add_option("--gap", options.gap, "--model gap: the films' thickness in scene units")
        ->check(positive())
        ->type_name("G");
}

void check_usage(const ModelOptions& options) {
    if ((options.model == "gap") != options.gap.has_value())
        throw UsageError("--model gap and --gap G, the films' thickness, go together");
}

scene::Scene in_model(scene::Scene scene, const ModelOptions& options, bool quiet) {
    if (options.model == "plain") return povray::without_priorities(std::move(scene));
    if (options.model == "contact") return scene;
    auto filmed = povray::with_films(std::move(scene), *options.gap);
    if (!quiet) print_film(filmed.thickness);
    return std::move(filmed.scene);
}

std::string film_text(const std::optional<povray::Thickness>& thickness) {
    return thickness ? fmt::format("{:.6g} to {:.6g} scene units thick", thickness->least,
                                   thickness->largest)
                     : "none: no solid cuts another";
}

void print_film(const std::optional<povray::Thickness>& thickness) {
    if (!thickness) return fmt::print(stderr, "no films: no solid cuts another\n");
    fmt::print(stderr, "films {}\n", film_text(thickness));
}

}  // namespace meniscus::cli
