#include "lang/session.hpp"

#include <fmt/format.h>

namespace meniscus::lang {

Session::Session(const Options& given) : options(given), library(options) {}

void Session::warn(const Span& span, std::string text) {
    if (warnings_.size() >= options.limits.warnings) return;
    auto warning = make_diagnostic(Diagnostic::Severity::warning, span, std::move(text));
    for (const auto& known : warnings_) {  // a loop says it once
        if (known.text == warning.text && known.location.line == warning.location.line &&
            known.location.column == warning.location.column &&
            known.location.file == warning.location.file) {
            return;
        }
    }
    warnings_.push_back(std::move(warning));
}

void Session::count_step(const Span& span) {
    if (++steps_taken_ > options.limits.loop_steps) {
        throw SourceError(
            span, fmt::format("stopped after {} steps of loops and macros: does this loop end?",
                              options.limits.loop_steps));
    }
}

void Session::enter_macro(std::string_view name, const Span& call) {
    count_step(call);
    if (++macros_ > options.limits.macro_depth) {
        throw SourceError(
            call,
            fmt::format("macros nested more than {} deep: does macro '{}' call itself without end?",
                        options.limits.macro_depth, name));
    }
    symbols.enter();
    steps_.push_back({fmt::format("in macro {} called at", name), call, nullptr});
}

void Session::enter_file(const Source& source, const Span& asked) {
    count_step(asked);
    if (++files_ > options.limits.include_depth) {
        throw SourceError(asked,
                          fmt::format("files included more than {} deep: does '{}' include itself?",
                                      options.limits.include_depth, source.name()));
    }
    symbols.enter();
    steps_.push_back({"included at", asked, &source});
}

void Session::leave() {
    --(steps_.back().file ? files_ : macros_);
    symbols.leave();
    steps_.pop_back();
}

std::vector<Diagnostic> Session::notes() const {
    constexpr std::size_t most_notes = 20;
    std::vector<Diagnostic> notes;
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
        if (notes.size() == most_notes) {
            notes.push_back({Diagnostic::Severity::note,
                             {},
                             fmt::format("and {} more levels", steps_.size() - most_notes),
                             {},
                             0});
            break;
        }
        const auto at = step->span.location();
        notes.push_back({Diagnostic::Severity::note,
                         {},
                         fmt::format("{} {}:{}:{}", step->what, at.file, at.line, at.column),
                         {},
                         0});
    }
    return notes;
}

std::filesystem::path Session::folder_of(const Span& span) {
    return span.source ? span.source->folder() : std::filesystem::path{};
}

}  // namespace meniscus::lang
