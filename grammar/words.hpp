#pragma once

#include <span>
#include <string_view>

namespace meniscus::grammar {

/// The language's own words: none of them can be declared. Each belongs to one class.
enum class WordClass {
    name,             // not reserved: the scene's own
    plain,            // hollow, gradient, sphere, ...
    color,            // rgb, color, red, ...: may start a colour
    constant,         // pi, x, clock, ...: a value by itself
    function,         // sin, vrotate, str, ...: a call where a parenthesis follows
    function_of_one,  // the same; its only argument may be a comparison
};

WordClass classify(std::string_view word);
inline bool is_reserved(std::string_view word) { return classify(word) != WordClass::name; }

inline bool is_function(std::string_view word) {
    const auto found = classify(word);
    return found == WordClass::function || found == WordClass::function_of_one;
}

/// All reserved words, sorted.
std::span<const std::string_view> reserved_words();

inline bool is_word_start(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
inline bool is_word_char(char c) { return is_word_start(c) || (c >= '0' && c <= '9'); }

}  // namespace meniscus::grammar
