#pragma once

#include <string>

#include "lang/interpret.hpp"

namespace meniscus::lang::test {

inline Interpreted interpret(const std::string& text, const Options& options = {}) {
    return interpret_text("test.scene", text, options);
}

/// What a scene prints: each of the expressions, as POV-Ray's str() or vstr() would.
inline std::string debug(const std::string& before, const std::string& text) {
    return interpret("#version 3.7;\n" + before + "\n#debug " + text + "\n").messages;
}

inline double number(const std::string& expression, const std::string& before = {}) {
    return std::stod(debug(before, "str(" + expression + ", 0, 12)"));
}

inline std::string vector(const std::string& expression, int size = 3,
                          const std::string& before = {}) {
    return debug(before, "vstr(" + std::to_string(size) + ", " + expression + ", \",\", 0, 3)");
}

/// The first error's text, empty if there is none.
inline std::string error(const std::string& text, const Options& options = {}) {
    try {
        interpret(text, options);
    } catch (const SourceError& e) {
        return e.primary().text;
    }
    return {};
}

/// The whole message as it would be printed.
inline std::string printed_error(const std::string& text, const Options& options = {}) {
    try {
        interpret(text, options);
    } catch (const SourceError& e) {
        return format(e);
    }
    return {};
}

}  // namespace meniscus::lang::test
