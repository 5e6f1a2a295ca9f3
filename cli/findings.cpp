#include "cli/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/version.hpp"

namespace meniscus::cli {
namespace {

using inspect::Finding;
using lang::Diagnostic;
using Json = nlohmann::ordered_json;

/// The line of a file that was readable a moment ago; nothing where it was not a file.
std::string source_line(const scene::Location& location) {
    std::string line;
    if (location.line <= 0) return line;
    std::ifstream file(location.file);
    for (int i = 0; i < location.line; ++i) {
        if (!std::getline(file, line)) return {};
    }
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

/// With a caret under the word that the location starts with.
Diagnostic diagnostic(Diagnostic::Severity severity, const scene::Location& location,
                      const std::string& text) {
    Diagnostic result{severity, location, text, source_line(location), 1};
    const auto is_word = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '#';
    };
    const std::size_t begin = std::size_t(std::max(location.column - 1, 0));
    std::size_t end = begin;
    while (end < result.line.size() && is_word(result.line[end])) ++end;
    result.length = std::max(int(end - begin), 1);
    return result;
}

bool is_same(const scene::Location& a, const scene::Location& b) {
    return a.file == b.file && a.line == b.line && a.column == b.column;
}

Diagnostic::Severity severity(const Finding& finding) {
    return finding.severity == Finding::Severity::warning ? Diagnostic::Severity::warning
                                                          : Diagnostic::Severity::note;
}

Json place(const scene::Location& location) {
    return {{"file", location.file}, {"line", location.line}, {"column", location.column}};
}

}  // namespace

std::vector<Finding> from_warnings(const std::vector<Diagnostic>& warnings) {
    std::vector<Finding> findings;
    for (const auto& warning : warnings) {
        Finding finding;
        finding.severity = warning.severity == Diagnostic::Severity::note
                               ? Finding::Severity::note
                               : Finding::Severity::warning;
        finding.lint = "language";
        finding.location = warning.location;
        finding.text = warning.text;
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::vector<Finding> from_unused(const std::vector<lang::UnusedObject>& objects) {
    std::vector<Finding> findings;
    for (const auto& object : objects) {
        Finding finding;
        finding.lint = "unused-object";
        finding.location = object.location;
        finding.text =
            fmt::format("{} is declared but never used: it is not in the scene", object.name);
        finding.advice = fmt::format("to put it there, write `object {{ {} }}`", object.name);
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::vector<Diagnostic> as_warnings(const std::vector<Finding>& findings, const std::string& file) {
    std::vector<Diagnostic> warnings;
    for (const auto& finding : findings) {
        warnings.push_back(diagnostic(severity(finding), finding.location, finding.text));
        if (warnings.back().location.file.empty()) warnings.back().location.file = file;
    }
    return warnings;
}

std::string format_findings(const std::vector<Finding>& findings) {
    std::string text;
    for (const auto& finding : findings) {
        text += lang::format(diagnostic(severity(finding), finding.location, finding.text));
        for (const auto& related : finding.related) {
            if (is_same(related.location, finding.location)) continue;
            text += lang::format(
                diagnostic(Diagnostic::Severity::note, related.location, related.text));
        }
        if (!finding.advice.empty()) text += fmt::format("    to do: {}\n", finding.advice);
    }
    return text + inspect::summary(findings) + '\n';
}

std::string format_findings_json(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const auto& finding : findings) {
        Json entry{
            {"severity", finding.severity == Finding::Severity::warning ? "warning" : "note"},
            {"lint", finding.lint}};
        entry.update(place(finding.location));
        entry["text"] = finding.text;
        entry["advice"] = finding.advice;
        entry["related"] = Json::array();
        for (const auto& related : finding.related) {
            auto other = place(related.location);
            other["text"] = related.text;
            entry["related"].push_back(std::move(other));
        }
        if (const auto& p = finding.position) entry["position"] = {p->x, p->y, p->z};
        if (finding.depth) entry["depth"] = *finding.depth;
        if (!finding.triangles.empty()) entry["triangles"] = finding.triangles;
        list.push_back(std::move(entry));
    }
    const Json json{{"version", version},
                    {"ok", !inspect::has_warnings(findings)},
                    {"findings", std::move(list)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace meniscus::cli
