#include "lang/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meniscus::lang {
namespace {

constexpr std::size_t longest_line = 200;

std::string_view name_of(Diagnostic::Severity severity) {
    switch (severity) {
        case Diagnostic::Severity::error:
            return "error";
        case Diagnostic::Severity::warning:
            return "warning";
        case Diagnostic::Severity::note:
            return "note";
    }
    return "";
}

/// Bytes that a terminal would obey stand as '?'.
std::string printable(std::string line) {
    for (char& c : line) {
        const bool is_control = (c >= 0 && c < ' ' && c != '\t') || c == 0x7f;
        if (is_control) c = '?';
    }
    return line;
}

}  // namespace

Diagnostic make_diagnostic(Diagnostic::Severity severity, const Span& span, std::string text) {
    Diagnostic diagnostic{severity, span.location(), std::move(text), {}, 0};
    if (span.source) {
        diagnostic.line = span.source->line_at(span.begin);
        const auto rest =
            static_cast<int>(diagnostic.line.size()) - (diagnostic.location.column - 1);
        diagnostic.length =
            std::clamp(static_cast<int>(span.end - span.begin), 1, std::max(rest, 1));
    }
    return diagnostic;
}

std::string format(const Diagnostic& d) {
    std::string out;
    if (d.location.line > 0) {
        out = fmt::format("{}:{}:{}: ", d.location.file, d.location.line, d.location.column);
    } else if (!d.location.file.empty()) {
        out = fmt::format("{}: ", d.location.file);
    }
    out += fmt::format("{}: {}\n", name_of(d.severity), d.text);
    if (d.location.line <= 0 || d.line.empty() || d.line.size() > longest_line) return out;

    std::string blanks;  // tabs stay tabs, so that the carets stand where the text stands
    for (int i = 0; i + 1 < d.location.column && i < static_cast<int>(d.line.size()); ++i) {
        blanks += d.line[static_cast<std::size_t>(i)] == '\t' ? '\t' : ' ';
    }
    out += fmt::format("    {}\n    {}{}\n", printable(d.line), blanks,
                       std::string(static_cast<std::size_t>(std::max(d.length, 1)), '^'));
    return out;
}

SourceError::SourceError(const Span& span, const std::string& text)
    : SourceError(make_diagnostic(Diagnostic::Severity::error, span, text)) {}

SourceError::SourceError(Diagnostic primary) : primary_(std::move(primary)) {
    what_ = fmt::format("{}:{}:{}: {}", primary_.location.file, primary_.location.line,
                        primary_.location.column, primary_.text);
}

std::string format(const SourceError& error) {
    auto out = format(error.primary());
    for (const auto& note : error.notes()) out += format(note);
    return out;
}

}  // namespace meniscus::lang
