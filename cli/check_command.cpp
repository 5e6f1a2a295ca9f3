#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "cli/command.hpp"
#include "cli/diagnostics.hpp"
#include "cli/findings.hpp"
#include "cli/scene_options.hpp"
#include "image/file.hpp"
#include "inspect/check.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::cli {
namespace {

struct CheckOptions {
    SceneOptions scene;
    std::string json;  // a file, or "-"
};

ExitCode run(CheckOptions options) {
    options.scene.outputs = {options.json};
    auto interpreted = interpret_scene(options.scene);
    auto findings = from_warnings(interpreted.warnings);
    std::ranges::move(from_unused(interpreted.unused_objects), std::back_inserter(findings));
    for (auto& finding : inspect::check(tracer::compile(std::move(interpreted.scene)))) {
        if (finding.location.file.empty()) finding.location.file = options.scene.file_name();
        findings.push_back(std::move(finding));
    }

    // The findings are what was asked for: they go to standard output, unless the JSON goes there.
    const auto text = format_findings(findings);
    if (options.json == image::standard_stream) {
        print_diagnostic(text);
    } else {
        image::write_file(image::standard_stream, text);
    }
    if (!options.json.empty()) image::write_file(options.json, format_findings_json(findings));
    return inspect::has_warnings(findings) ? ExitCode::check_failed : ExitCode::done;
}

}  // namespace

Command make_check_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "check",
        "Find what will go wrong with a scene before it is rendered; exit code 4 if anything");
    const auto options = std::make_shared<CheckOptions>();
    options->scene.number_triangles = true;
    add_scene_options(*command, options->scene);
    command->add_option("--json", options->json, "Write the findings as JSON; - is standard output")
        ->type_name("FILE|-");
    return {command, [options] { return run(*options); }};
}

}  // namespace meniscus::cli
