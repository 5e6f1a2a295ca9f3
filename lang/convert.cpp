#include <fmt/format.h>

#include <cmath>

#include "lang/evaluate.hpp"

namespace meniscus::lang {

bool is_true(double value) { return std::abs(value) >= 1e-10; }

SourceError refuse(const Refusal& refusal) {
    SourceError error(refusal.where,
                      fmt::format("this is POV-Ray, but not supported here: `{}`", refusal.what));
    if (!refusal.advice.empty())
        error.add_note({Diagnostic::Severity::note, {}, refusal.advice, {}, 0});
    return error;
}

double to_number(const Value& value, const Span& span) {
    if (const auto* number = value.get<double>()) return *number;
    if (const auto* refusal = value.get<Refusal>()) throw refuse(*refusal);
    throw SourceError(span, fmt::format("expected a number, found {}", kind_of(value)));
}

Vector to_vector(const Value& value, const Span& span) {
    if (const auto* vector = value.get<Vector>()) return *vector;
    if (const auto* number = value.get<double>()) {
        Vector filled;
        filled.at.fill(*number);
        return filled;
    }
    if (const auto* refusal = value.get<Refusal>()) throw refuse(*refusal);
    throw SourceError(span, fmt::format("expected a vector, found {}", kind_of(value)));
}

Vector to_color(const Value& value, const Span& span) {
    if (value.data.index() > 2 && !value.get<Refusal>()) {
        throw SourceError(span, fmt::format("expected a color, found {}", kind_of(value)));
    }
    auto color = to_vector(value, span);
    color.size = 5;
    color.is_color = true;
    return color;
}

const std::string& to_string(const Value& value, const Span& span) {
    if (const auto* text = value.get<std::string>()) return *text;
    if (const auto* refusal = value.get<Refusal>()) throw refuse(*refusal);
    throw SourceError(span, fmt::format("expected a string, found {}", kind_of(value)));
}

}  // namespace meniscus::lang
