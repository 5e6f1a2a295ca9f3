#pragma once

#include "lang/ast.hpp"
#include "lang/session.hpp"
#include "lang/value.hpp"

namespace meniscus::lang {

/// `array[2][3] { ... }`.
Value read_array(Session& session, const ast::Array& node, const Span& span);

}  // namespace meniscus::lang
