#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/comparison.hpp"

namespace meniscus::compare {

/// A command line and what it is for.
struct Command {
    std::string purpose, line;
};

/// The ray tree of a pixel on one side: text, and an SVG picture.
struct TracedSide {
    std::string title, trace, diagram;
};

/// Why a pixel has the colours that it has.
struct Explanation {
    int x = 0, y = 0;
    std::vector<TracedSide> sides;
    std::vector<Command> commands;
};

/// What a report says beside the comparison itself.
struct ReportWords {
    std::string title;
    std::vector<std::pair<std::string, std::string>> settings;
    std::vector<Command> commands;          // to do it all again
    std::vector<Explanation> explanations;  // of the worst pixels, as far as they are known
    std::optional<double> tolerance;        // of the RMSE
};

/// An HTML page of one file that needs no network: both pictures to flip, slide and zoom, the
/// signed difference, the numbers and how to make them again.
std::string format_report(const Comparison& comparison, const ReportWords& words);

}  // namespace meniscus::compare
