#pragma once

#include <string_view>

#include "lang/session.hpp"
#include "lang/value.hpp"

namespace meniscus::lang {

/// + - * / < <= = != >= > & | on numbers, vectors, colours and (=, !=) strings.
Value apply_operator(Session& session, std::string_view op, const Value& left, const Value& right,
                     const Span& span);

/// - + ! in front of a value.
Value apply_sign(char sign, const Value& value, const Span& span);

}  // namespace meniscus::lang
