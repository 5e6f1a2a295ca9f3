#pragma once

#include <string>
#include <vector>

#include "cli/stopwatch.hpp"
#include "lang/diagnostic.hpp"
#include "tracer/render.hpp"

namespace meniscus::cli {

/// What one run of `render` did, for people and for programs.
struct Report {
    std::string scene;    // as named on the command line
    std::string options;  // canonical
    int width = 0, height = 0;
    Duration parse, build, render;
    const tracer::RenderScene& render_scene;
    const tracer::Rendered& rendered;
    const std::vector<lang::Diagnostic>& warnings;
};

std::string format_statistics(const Report& report);
std::string format_json(const Report& report);

}  // namespace meniscus::cli
