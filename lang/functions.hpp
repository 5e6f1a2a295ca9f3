#pragma once

#include <vector>

#include "lang/session.hpp"
#include "lang/value.hpp"

namespace meniscus::lang {

struct Argument {
    Value value;
    Span span;
};

/// Calls one of the language's own functions: sin, vrotate, str, ...
Value call_function(Session& session, std::string_view name, const std::vector<Argument>& arguments,
                    const Span& span);

}  // namespace meniscus::lang
