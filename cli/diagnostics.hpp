#pragma once

#include <string_view>

namespace meniscus::cli {

/// A diagnostic as `lang::format` writes it, to standard error: in colour on a terminal.
void print_diagnostic(std::string_view formatted);

/// One line about something that is not in a scene: "meniscus: error: ...".
void print_error(std::string_view text);
/// The same as a warning.
void print_warning(std::string_view text);

}  // namespace meniscus::cli
