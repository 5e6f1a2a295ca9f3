#pragma once

#include "grammar/scene_grammar.hpp"

/// What to say where the grammar says `must` and the text says otherwise.
namespace meniscus::grammar {

template <class Rule>
inline constexpr const char* expected = nullptr;

template <>
inline constexpr auto expected<comment_end> = "expected '*/' to end this comment";
template <>
inline constexpr auto expected<string_end> = "expected '\"' to end this string";
template <>
inline constexpr auto expected<only_argument> = "expected a value";
template <>
inline constexpr auto expected<logic> = "expected a value";
template <>
inline constexpr auto expected<operand> = "expected a value";
template <>
inline constexpr auto expected<term> = "expected a value after '+' or '-'";
template <>
inline constexpr auto expected<factor> = "expected a value after '*' or '/'";
template <>
inline constexpr auto expected<compared> = "expected a value after '&' or '|'";
template <>
inline constexpr auto expected<colon> = "expected ':' and the other value of 'condition ? a : b'";
template <>
inline constexpr auto expected<close_paren> = "expected ')'";
template <>
inline constexpr auto expected<close_angle> = "expected a number, or '>' to close the vector";
template <>
inline constexpr auto expected<close_bracket> = "expected ']'";
template <>
inline constexpr auto expected<close_brace> = "expected '}' to close the block";
template <>
inline constexpr auto expected<raw_close> = "expected '}' to close the function";
template <>
inline constexpr auto expected<open_brace> = "expected '{'";
template <>
inline constexpr auto expected<open_paren> = "expected '('";
template <>
inline constexpr auto expected<array_sizes> = "expected the array's size, as in array[3]";
template <>
inline constexpr auto expected<target> = "expected a name to declare";
template <>
inline constexpr auto expected<name> = "expected a name";
template <>
inline constexpr auto expected<equals> = "expected '='";
template <>
inline constexpr auto expected<rvalue> = "expected a value";
template <>
inline constexpr auto expected<file_name> = "expected a file name in quotes";
template <>
inline constexpr auto expected<version_number> = "expected a version number, as 3.7";
template <>
inline constexpr auto expected<message_text> = "expected a text in quotes";
template <>
inline constexpr auto expected<condition> = "expected '(' and a condition";
template <>
inline constexpr auto expected<condition_open> = "expected '('";
template <>
inline constexpr auto expected<for_head> =
    "expected 'name, first, last' or 'name, first, last, step'";
template <>
inline constexpr auto expected<macro_name> = "expected the macro's name";
template <>
inline constexpr auto expected<end> = "expected '#end'";
template <>
inline constexpr auto expected<raw_end> = "expected '#end'";
template <>
inline constexpr auto expected<known_directive> = "unknown directive";
template <>
inline constexpr auto expected<end_of_file> =
    "expected an object, a directive or the end of the file";

/// Only what is written with `must` is final: a rule that is merely tried may fail in silence.
struct messages {
    template <class>
    static constexpr bool raise_on_failure = false;
    template <class Rule>
    static constexpr const char* message = expected<Rule>;
};

}  // namespace meniscus::grammar
