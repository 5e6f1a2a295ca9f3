#pragma once

#include "lang/ast.hpp"
#include "lang/session.hpp"
#include "lang/value.hpp"

namespace meniscus::lang {

Value evaluate(Session& session, const ast::Expression& expression);

/// The expression's value as what is needed there; `SourceError` if it is something else.
double evaluate_number(Session& session, const ast::Expression& expression);
std::string evaluate_string(Session& session, const ast::Expression& expression);
bool evaluate_condition(Session& session, const ast::Expression& expression);

double to_number(const Value& value, const Span& span);
Vector to_vector(const Value& value, const Span& span);
/// A number fills all five components.
Vector to_color(const Value& value, const Span& span);
const std::string& to_string(const Value& value, const Span& span);

bool is_true(double value);

/// What says that the item is POV-Ray's but cannot be used here.
SourceError refuse(const Refusal& refusal);

/// The variable, with indices followed; null if it is not declared.
const Value* find_variable(Session& session, const ast::Variable& variable, const Span& span);
/// An index into an array, as a place in `elements`; throws unless within range.
std::size_t element_place(Session& session, const ArrayValue& array,
                          const ast::Expressions& indices, std::size_t& used);

}  // namespace meniscus::lang
