#pragma once

#include <string_view>

#include "lang/ast.hpp"

namespace meniscus::lang {

/// The value of a number as it is spelled; one that is too large is infinite.
double parse_number(std::string_view text);

/// A string with its quotes: escapes are resolved.
ast::Text parse_string(std::string_view text);

}  // namespace meniscus::lang
