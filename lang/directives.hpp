#pragma once

#include "lang/ast.hpp"
#include "lang/library.hpp"
#include "lang/session.hpp"

namespace meniscus::lang {

/// Carries out a directive that has no items to splice: declarations, messages, #version, #default.
void execute(Session& session, const ast::Item& item);

/// Finds and parses the file that an #include names.
const ParsedFile& open_include(Session& session, const ast::Include& node);

bool is_declared(Session& session, const ast::Target& target);

}  // namespace meniscus::lang
