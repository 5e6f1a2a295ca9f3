#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/exit_code.hpp"

namespace meniscus::cli {

/// A subcommand: its options, and what it does once they are read.
struct Command {
    CLI::App* app;
    std::function<ExitCode()> run;
};

/// To add a subcommand: write its file, declare its maker here and list it in main.cpp.
Command make_render_command(CLI::App& app);
Command make_check_command(CLI::App& app);
Command make_inspect_command(CLI::App& app);
Command make_compare_command(CLI::App& app);
Command make_export_command(CLI::App& app);
Command make_bench_command(CLI::App& app);

}  // namespace meniscus::cli
