#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/diagnostics.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/povray_spelling.hpp"
#include "cli/version.hpp"
#include "compare/comparison.hpp"
#include "image/file.hpp"
#include "lang/diagnostic.hpp"
#include "povray/error.hpp"
#include "povray/run.hpp"

namespace {

using namespace meniscus;
using cli::ExitCode;

constexpr auto footer = R"(POV-Ray's spellings are understood as well:
  +I +O +W +H +SC +SR +EC +ER +A +R +AM +FN +FN16 +FE +WT +L -A -D, Declare=NAME=VALUE and the like.

Exit codes: 0 done, 1 our fault, 2 the scene or an option is wrong, 3 a file cannot be read or written,
  4 a comparison, --strict or check found something, 130 interrupted.)";

/// CLI11 would only say that a subcommand is required.
void check_command(const std::vector<std::string>& words, const std::vector<cli::Command>& known) {
    if (words.empty()) throw cli::UsageError("no command is given");
    if (words.front().starts_with('-')) return;
    std::vector<std::string> names;
    for (const auto& command : known) names.push_back(command.app->get_name());
    if (std::ranges::find(names, words.front()) == names.end())
        throw cli::UsageError(fmt::format("'{}' is not a command; there are: {}", words.front(),
                                          fmt::join(names, ", ")));
}

ExitCode run(const std::vector<std::string>& arguments) {
    CLI::App app{
        "Meniscus renders solids that touch, overlap and nest: a ray tracer for glass in water in "
        "glass.",
        "meniscus"};
    app.set_version_flag("--version", fmt::format("meniscus {}", cli::version));
    app.set_help_all_flag("--help-all", "The options of all subcommands");
    app.require_subcommand(1);
    app.footer(footer);
    const std::vector<cli::Command> commands = {
        cli::make_render_command(app),  cli::make_check_command(app),
        cli::make_inspect_command(app), cli::make_compare_command(app),
        cli::make_export_command(app),  cli::make_bench_command(app),
    };
    auto words = cli::translate_povray_spellings(arguments);
    check_command(words, commands);
    try {
        std::ranges::reverse(words);  // CLI11 takes them from the back
        app.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return ExitCode(app.exit(error));
        throw cli::UsageError(error.what());
    }
    const auto chosen = std::ranges::find_if(
        commands, [](const cli::Command& command) { return command.app->parsed(); });
    return chosen->run();
}

ExitCode run_and_report(const std::vector<std::string>& arguments) {
    try {
        return run(arguments);
    } catch (const cli::UsageError& error) {
        cli::print_error(fmt::format("{}; see meniscus --help", error.what()));
        return ExitCode::wrong_input;
    } catch (const lang::FileError& error) {
        cli::print_diagnostic(lang::format(error));
        return ExitCode::file_failed;
    } catch (const lang::SourceError& error) {
        cli::print_diagnostic(lang::format(error));
        return ExitCode::wrong_input;
    } catch (const povray::ExportError& error) {
        cli::print_diagnostic(lang::format(lang::Diagnostic{
            lang::Diagnostic::Severity::error, error.location, error.what(), {}, 0}));
        return ExitCode::wrong_input;
    } catch (const image::FileError& error) {
        cli::print_error(error.what());
        return ExitCode::file_failed;
    } catch (const compare::Mismatch& error) {
        cli::print_error(error.what());
        return ExitCode::wrong_input;
    } catch (const povray::NotInstalled& error) {
        cli::print_error(error.what());
        return ExitCode::file_failed;
    } catch (const povray::RunFailed& error) {
        cli::print_error(error.what());
        return ExitCode::wrong_input;
    } catch (const std::bad_alloc&) {
        cli::print_error("there is not enough memory for this picture or scene");
        return ExitCode::wrong_input;
    } catch (const std::exception& error) {
        cli::print_error(fmt::format("internal error: {}", error.what()));
        return ExitCode::our_fault;
    }
}

}  // namespace

int main(int argc, char** argv) {
    cli::ignore_broken_pipes();
    return int(run_and_report({argv + 1, argv + argc}));
}
