#include "lang/operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lang/evaluate.hpp"

namespace meniscus::lang {
namespace {

double calculate(char op, double a, double b) {
    switch (op) {
        case '+':
            return a + b;
        case '-':
            return a - b;
        case '*':
            return a * b;
        default:
            return b == 0.0 ? std::numeric_limits<double>::infinity() : a / b;
    }
}

bool compare(std::string_view op, double a, double b) {
    const bool equal = a == b || std::abs(a - b) < 1e-10;
    if (op == "=") return equal;
    if (op == "!=") return !equal;
    if (op == "<") return a < b;  // the strict ones have no tolerance in POV-Ray either
    if (op == ">") return a > b;
    if (op == "<=") return a < b || equal;
    return a > b || equal;  // >=
}

bool is_arithmetic(char op) { return op == '+' || op == '-' || op == '*' || op == '/'; }

Value arithmetic(char op, const Value& left, const Value& right, const Span& span) {
    const auto* a = left.get<double>();
    const auto* b = right.get<double>();
    if (a && b) return {calculate(op, *a, *b)};
    const auto va = to_vector(left, span), vb = to_vector(right, span);
    Vector result;
    result.size = std::max(a ? 0 : va.size, b ? 0 : vb.size);
    result.is_color = (!a && va.is_color) || (!b && vb.is_color);
    for (std::size_t i = 0; i < static_cast<std::size_t>(result.size); ++i) {
        result.at[i] = calculate(op, va.at[i], vb.at[i]);
    }
    return {result};
}

bool has_zero(const Value& value) {
    if (const auto* number = value.get<double>()) return *number == 0.0;
    if (const auto* v = value.get<Vector>()) {
        return std::any_of(v->at.begin(), v->at.begin() + v->size,
                           [](double c) { return c == 0.0; });
    }
    return false;
}

}  // namespace

Value apply_operator(Session& session, std::string_view op, const Value& left, const Value& right,
                     const Span& span) {
    if (left.get<Refusal>()) return left;
    if (right.get<Refusal>()) return right;
    if (is_arithmetic(op.front())) {
        if (op == "/" && has_zero(right)) session.warn(span, "division by zero");
        return arithmetic(op.front(), left, right, span);
    }
    const auto* a = left.get<std::string>();
    const auto* b = right.get<std::string>();
    if (a && b && (op == "=" || op == "!=")) return {(*a == *b) == (op == "=") ? 1.0 : 0.0};
    const double x = to_number(left, span), y = to_number(right, span);
    if (op == "&") return {is_true(x) && is_true(y) ? 1.0 : 0.0};
    if (op == "|") return {is_true(x) || is_true(y) ? 1.0 : 0.0};
    return {compare(op, x, y) ? 1.0 : 0.0};
}

Value apply_sign(char sign, const Value& value, const Span& span) {
    if (value.get<Refusal>()) return value;
    const auto apply = [sign](double v) {
        return sign == '-' ? -v : sign == '+' ? v : is_true(v) ? 0.0 : 1.0;
    };
    if (const auto* number = value.get<double>()) return {apply(*number)};
    auto v = to_vector(value, span);
    for (std::size_t i = 0; i < static_cast<std::size_t>(v.size); ++i) v.at[i] = apply(v.at[i]);
    return {v};
}

}  // namespace meniscus::lang
