#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/metrics.hpp"
#include "compare/plot.hpp"

namespace meniscus::compare {

/// Gaps to try, the widest first.
std::vector<double> logarithmic_steps(double first, double last, int per_decade);

/// One width of the gap that stands where two media should meet.
struct SweepRow {
    double gap = 0.0;               // scene units; 0: the surfaces coincide
    std::optional<Metrics> film;    // POV-Ray's picture against the exact one with this gap
    std::optional<Metrics> povray;  // POV-Ray's picture against exact contact
    Metrics meniscus;               // Meniscus' picture of this gap against exact contact
    double povray_seconds = 0.0, meniscus_seconds = 0.0;  // CPU, of the trace stage
    std::string failure;                                  // why POV-Ray has no picture
    std::vector<std::string> warnings;  // why POV-Ray's picture may not be that of this gap
};

/// What a gap costs, and where it breaks.
struct Sweep {
    std::string title;
    std::vector<SweepRow> rows;
};

std::string format_text(const Sweep& sweep);
/// With a line of names; numbers of six digits.
std::string format_csv(const Sweep& sweep);
/// A table in Markdown.
std::string format_markdown(const Sweep& sweep);
Plot make_plot(const Sweep& sweep);
/// A page of one file: the plot, the table, what they say, and the command to make them again.
std::string format_page(const Sweep& sweep, const std::string& command);

}  // namespace meniscus::compare
