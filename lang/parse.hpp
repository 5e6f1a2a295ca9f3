#pragma once

#include "lang/ast.hpp"
#include "lang/source.hpp"

namespace meniscus::lang {

/// Reads a whole file. Throws SourceError.
ast::Program parse(const Source& source);

/// Reads a part of a file, as a macro's body.
ast::Program parse(const Span& part);

}  // namespace meniscus::lang
