#include "cli/scene_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string_view>

#include "cli/diagnostics.hpp"
#include "cli/exit_code.hpp"
#include "cli/outputs.hpp"

namespace meniscus::cli {
namespace {

bool is_name(std::string_view text) {
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !text.empty() && is_letter(text.front()) && std::ranges::all_of(text, [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9');
    });
}

std::pair<std::string, std::string> parse_declaration(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || !is_name(std::string_view(text).substr(0, equals)))
        throw UsageError(fmt::format("--declare '{}': it must be NAME=VALUE", text));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

lang::Options language_options(const SceneOptions& options) {
    lang::Options result;
    result.image_width = options.width;
    result.image_height = options.height;
    result.number_triangles = options.number_triangles;
    for (const auto& path : options.library_paths) result.library_paths.emplace_back(path);
    for (const auto& text : options.declarations)
        result.declares.push_back(parse_declaration(text));
    return result;
}

std::string read_standard_input() {
    return {std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string SceneOptions::file_name() const {
    return scene == "-" ? "stdin" : std::filesystem::path(scene).filename().string();
}

std::string SceneOptions::stem() const {
    return std::filesystem::path(file_name()).stem().string();
}

void add_scene_options(CLI::App& app, SceneOptions& o) {
    app.add_option("SCENE", o.scene, "The scene file; - is standard input")
        ->required()
        ->type_name("");
    add_scene_settings(app, o);
}

void add_scene_settings(CLI::App& app, SceneOptions& o) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;
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

lang::Interpreted interpret_scene(const SceneOptions& options) {
    check_outputs(options.outputs, {options.scene});
    const auto language = language_options(options);
    auto interpreted = options.scene == "-"
                           ? lang::interpret_text("standard input", read_standard_input(), language)
                           : lang::interpret_file(options.scene, language);
    check_outputs(options.outputs, interpreted.files);
    fmt::print(stderr, "{}", interpreted.messages);
    return interpreted;
}

lang::Interpreted read_scene(const SceneOptions& options) {
    auto interpreted = interpret_scene(options);
    for (const auto& warning : interpreted.warnings) print_diagnostic(lang::format(warning));
    return interpreted;
}

}  // namespace meniscus::cli
