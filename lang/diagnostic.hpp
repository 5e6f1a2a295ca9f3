#pragma once

#include <exception>
#include <string>
#include <vector>

#include "lang/source.hpp"
#include "scene/location.hpp"

namespace meniscus::lang {

/// One message about a place in a scene file.
struct Diagnostic {
    enum class Severity { error, warning, note };
    Severity severity = Severity::error;
    scene::Location location;
    std::string text;
    std::string line;  // the source line, empty if there is none to show
    int length = 0;    // of the part to underline, from the location's column
};

Diagnostic make_diagnostic(Diagnostic::Severity severity, const Span& span, std::string text);

/// As `file:line:column: error: text`, then the line and carets under the part that is meant.
std::string format(const Diagnostic& diagnostic);

/// The scene's text is wrong: what and where, and for each macro or include on the way there a
/// note.
class SourceError : public std::exception {
public:
    SourceError(const Span& span, const std::string& text);
    explicit SourceError(Diagnostic primary);

    const Diagnostic& primary() const { return primary_; }
    const std::vector<Diagnostic>& notes() const { return notes_; }
    void add_note(Diagnostic note) { notes_.push_back(std::move(note)); }
    const char* what() const noexcept override { return what_.c_str(); }

private:
    Diagnostic primary_;
    std::vector<Diagnostic> notes_;
    std::string what_;
};

/// A file that cannot be read: the scene itself, an include, a mesh.
class FileError : public SourceError {
public:
    using SourceError::SourceError;
};

/// The error and its notes, as `format` prints each.
std::string format(const SourceError& error);

}  // namespace meniscus::lang
