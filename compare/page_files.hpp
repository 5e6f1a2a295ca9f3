#pragma once

#include <string_view>

/// The room's HTML, CSS and JavaScript files as they were when the program was built.
namespace meniscus::compare::page_files {

extern const std::string_view page_html, page_css;
extern const std::string_view comparison_html, comparison_css, comparison_js;

}  // namespace meniscus::compare::page_files
