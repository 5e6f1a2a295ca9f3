#include "inspect/finding.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meniscus::inspect {

std::string summary(const std::vector<Finding>& findings) {
    const auto warnings =
        std::ranges::count(findings, Finding::Severity::warning, &Finding::severity);
    const auto notes = std::ranges::ssize(findings) - warnings;
    auto text = fmt::format("{} warning{}", warnings, warnings == 1 ? "" : "s");
    if (notes > 0) text += fmt::format(", {} note{}", notes, notes == 1 ? "" : "s");
    return text;
}

bool has_warnings(const std::vector<Finding>& findings) {
    return std::ranges::any_of(findings, [](const Finding& finding) {
        return finding.severity == Finding::Severity::warning;
    });
}

}  // namespace meniscus::inspect
