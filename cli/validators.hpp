#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace meniscus::cli {

/// A finite number and nothing else.
inline std::optional<double> parse_number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// CLI11's own PositiveNumber lets "nan" and "inf" pass.
inline CLI::Validator positive() {
    return {[](std::string& text) {
                const auto value = parse_number(text);
                return value && *value > 0.0 ? std::string()
                                             : "'" + text + "' is not a number above 0";
            },
            ""};
}

inline CLI::Validator not_negative() {
    return {[](std::string& text) {
                const auto value = parse_number(text);
                return value && *value >= 0.0 ? std::string()
                                              : "'" + text + "' is not a number from 0 up";
            },
            ""};
}

}  // namespace meniscus::cli
