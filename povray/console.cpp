#include "povray/console.hpp"

#include <regex>
#include <sstream>

namespace meniscus::povray {
namespace {

/// Messages are wrapped at 80 columns: what goes on begins with a blank.
std::vector<std::string> unwrapped(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(' ') && !lines.empty()) {
            lines.back() += line;
        } else {
            lines.push_back(line);
        }
    }
    return lines;
}

}  // namespace

Console::Console(const std::string& text) {
    const std::regex warning("^(File '.*' line [0-9]+: )?([A-Z][a-z]+ )?Warning: .*");
    const std::regex error("^(File '.*' line [0-9]+: )?([A-Z][a-z]+ )?([Ee]rror|Problem).*");
    bool failed = false;
    for (const auto& line : unwrapped(text)) {
        if (std::regex_match(line, warning)) warnings_.push_back(line);
        failed = failed || std::regex_match(line, error);
        if (failed) error_ += line + '\n';
    }
    if (!failed) error_ = text;

    const std::regex times(
        "Trace Time:[^(]*\\(([0-9.]+) seconds\\)\\s+using [0-9]+ thread\\(s\\) with ([0-9.]+) "
        "CPU-seconds");
    std::smatch match;
    if (std::regex_search(text, match, times)) {
        seconds_ = std::stod(match[1]);
        cpu_seconds_ = std::stod(match[2]);
    }
}

}  // namespace meniscus::povray
