#include "cli/scene_options.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/diagnostics.hpp"
#include "cli/exit_code.hpp"
#include "cli/validators.hpp"

namespace meniscus::cli {
namespace {

std::pair<std::string, double> parse_declaration(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw UsageError(fmt::format("--declare '{}': it must be NAME=VALUE", text));
    const auto value = parse_number(std::string_view(text).substr(equals + 1));
    if (!value)
        throw UsageError(
            fmt::format("--declare '{}': '{}' is not a number", text, text.substr(equals + 1)));
    return {text.substr(0, equals), *value};
}

lang::Options language_options(const SceneOptions& options) {
    lang::Options result;
    result.width = options.width;
    result.height = options.height;
    for (const auto& path : options.library_paths) result.library_paths.emplace_back(path);
    for (const auto& text : options.declarations)
        result.declarations.push_back(parse_declaration(text));
    return result;
}

}  // namespace

std::string SceneOptions::file_name() const {
    return scene == "-" ? "stdin" : std::filesystem::path(scene).filename().string();
}

std::string SceneOptions::stem() const {
    return std::filesystem::path(file_name()).stem().string();
}

void add_scene_options(CLI::App& app, SceneOptions& o) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;
    app.add_option("SCENE", o.scene, "The scene file; - is standard input")
        ->required()
        ->type_name("");
    app.add_option("-W,--width", o.width, "Pixels in a row")
        ->check(CLI::Range(1, 65536))
        ->multi_option_policy(last)
        ->type_name("N")
        ->capture_default_str()
        ->group("Picture");
    app.add_option("-H,--height", o.height, "Rows of pixels")
        ->check(CLI::Range(1, 65536))
        ->multi_option_policy(last)
        ->type_name("N")
        ->capture_default_str()
        ->group("Picture");
    app.add_option("--declare", o.declarations, "As #declare NAME = VALUE; at the scene's start")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    app.add_option("-L", o.library_paths, "Where to look for included files; may be repeated")
        ->allow_extra_args(false)
        ->type_name("DIR");
}

lang::Interpreted read_scene(const SceneOptions& options) {
    auto interpreted = lang::interpret_file(options.scene, language_options(options));
    for (const auto& warning : interpreted.warnings) print_diagnostic(lang::format(warning));
    return interpreted;
}

}  // namespace meniscus::cli
