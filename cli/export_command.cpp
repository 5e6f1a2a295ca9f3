#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/command.hpp"
#include "cli/diagnostics.hpp"
#include "cli/model_options.hpp"
#include "cli/scene_options.hpp"
#include "cli/validators.hpp"
#include "image/file.hpp"
#include "povray/export.hpp"
#include "povray/film.hpp"
#include "povray/scale.hpp"

namespace meniscus::cli {
namespace {

struct ExportOptions {
    SceneOptions scene;
    std::string target = "povray", model = "contact", output;
    std::optional<double> gap, scale;
};

povray::Model model_of(const std::string& name) {
    return name == "plain"     ? povray::Model::plain
           : name == "contact" ? povray::Model::contact
                               : povray::Model::gap;
}

ExitCode run(const ExportOptions& options) {
    const auto model = model_of(options.model);
    if (model == povray::Model::gap && !options.gap)
        throw UsageError("--model gap needs --gap G, the films' thickness in scene units");
    if (model != povray::Model::gap && options.gap)
        throw UsageError("--gap belongs to --model gap");
    const auto output = options.output.empty() ? options.scene.stem() + ".pov" : options.output;
    std::error_code unknown;
    if (options.output.empty() && std::filesystem::equivalent(output, options.scene.scene, unknown))
        throw UsageError(fmt::format(
            "the export of '{0}' would be '{0}' itself: name another file, as -o {1}.export.pov",
            output, options.scene.stem()));
    auto scene_options = options.scene;
    scene_options.outputs = {output};
    const auto interpreted = read_scene(scene_options);
    const auto exported =
        povray::export_scene(interpreted.scene, {.model = model,
                                                 .gap = options.gap.value_or(0.0),
                                                 .scale = options.scale,
                                                 .source = options.scene.file_name()});
    image::write_file(output, exported.text);
    if (model == povray::Model::gap)
        print_film(povray::with_films(interpreted.scene, *options.gap).thickness);
    if (model == povray::Model::contact)
        fmt::print(stderr, "overlap {:.3g} scene units\n", exported.overlap);
    fmt::print(stderr, "scale {:g}: POV-Ray sees from {:.2g} to {:.2g} scene units\n",
               exported.scale, povray::nearest / exported.scale, povray::farthest / exported.scale);
    for (const auto& warning : exported.warnings) print_warning(warning);
    return ExitCode::done;
}

}  // namespace

Command make_export_command(CLI::App& app) {
    auto* command = app.add_subcommand("export", "Write a scene in POV-Ray's own language");
    const auto options = std::make_shared<ExportOptions>();
    add_scene_options(*command, options->scene);
    command->add_option("--to", options->target, "The language to write")
        ->check(CLI::IsMember({"povray"}))
        ->type_name("povray")
        ->capture_default_str();
    command
        ->add_option("--model", options->model,
                     "What stands for priorities: contact (the nested picture itself), gap (films "
                     "between solids) or plain (nothing)")
        ->check(CLI::IsMember({"contact", "gap", "plain"}))
        ->type_name("MODEL")
        ->capture_default_str();
    command->add_option("--gap", options->gap, "--model gap: the films' thickness in scene units")
        ->check(positive())
        ->type_name("G");
    command
        ->add_option("--scale", options->scale,
                     "Units of the export in one of the scene; default: by the scene's size")
        ->check(positive())
        ->type_name("S");
    command
        ->add_option("-o,--output", options->output,
                     "Default: SCENE.pov, in this folder; - is standard output")
        ->type_name("OUT.pov");
    return {command, [options] { return run(*options); }};
}

}  // namespace meniscus::cli
