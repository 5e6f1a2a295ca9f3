#pragma once

#include <string>
#include <vector>

#include "inspect/finding.hpp"
#include "lang/diagnostic.hpp"
#include "lang/unused_objects.hpp"

namespace meniscus::cli {

/// What the reader of the scene warned of, as findings of `check`.
std::vector<inspect::Finding> from_warnings(const std::vector<lang::Diagnostic>& warnings);

std::vector<inspect::Finding> from_unused(const std::vector<lang::UnusedObject>& objects);

/// The findings as the reader of the scene would have warned of them; `file` is where those without
/// a place belong.
std::vector<lang::Diagnostic> as_warnings(const std::vector<inspect::Finding>& findings,
                                          const std::string& file);

/// As `file:line:column: warning: text`, the source line, and what to do about it; last a line that
/// counts them.
std::string format_findings(const std::vector<inspect::Finding>& findings);

std::string format_findings_json(const std::vector<inspect::Finding>& findings);

}  // namespace meniscus::cli
