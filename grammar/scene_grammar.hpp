#pragma once

#include <tao/pegtl.hpp>

#include "grammar/words.hpp"

/// How a scene file is spelled. Rules only: which words mean what is known elsewhere, so that a new
/// object or keyword leaves this file alone. README.md says the same for people.
namespace meniscus::grammar {

namespace peg = tao::pegtl;

// Blanks and comments; block comments nest. Some files end in the Control-Z of old systems.

struct block_comment;
struct line_comment : peg::seq<peg::two<'/'>, peg::star<peg::not_one<'\n'>>> {};
struct comment_end : peg::string<'*', '/'> {};
struct comment_text : peg::star<peg::not_at<comment_end>, peg::sor<block_comment, peg::any>> {};
struct block_comment : peg::if_must<peg::string<'/', '*'>, comment_text, comment_end> {};
struct blank : peg::one<' ', '\t', '\r', '\n', '\f', '\v', '\x1a'> {};
struct spacing : peg::star<peg::sor<blank, line_comment, block_comment>> {};

template <class... Rules>
struct token : peg::seq<Rules..., spacing> {};
template <char C>
struct mark : token<peg::one<C>> {};

// Words

template <WordClass... Classes>
struct word_of {
    using rule_t = word_of;
    using subs_t = peg::empty_list;
    template <class Input>
    static bool match(Input& in) {
        const auto* begin = in.current();
        const auto* end = begin;
        if (end == in.end() || !is_word_start(*end)) return false;
        while (end != in.end() && is_word_char(*end)) ++end;
        const auto found = classify({begin, static_cast<std::size_t>(end - begin)});
        if (((found != Classes) && ...)) return false;
        in.bump_in_this_line(static_cast<std::size_t>(end - begin));
        return true;
    }
};
struct identifier : token<peg::identifier> {};
struct name : token<word_of<WordClass::name>> {};
struct word : token<word_of<WordClass::plain, WordClass::color, WordClass::function,
                            WordClass::function_of_one>> {};
struct color_word : token<word_of<WordClass::color>> {};
struct channel_name
    : peg::sor<peg::keyword<'r', 'e', 'd'>, peg::keyword<'g', 'r', 'e', 'e', 'n'>,
               peg::keyword<'b', 'l', 'u', 'e'>, peg::keyword<'f', 'i', 'l', 't', 'e', 'r'>,
               peg::keyword<'t', 'r', 'a', 'n', 's', 'm', 'i', 't'>,
               peg::keyword<'a', 'l', 'p', 'h', 'a'>> {};
struct constant : token<word_of<WordClass::constant>> {};
struct function_name : token<word_of<WordClass::function>> {};
struct function_of_one : token<word_of<WordClass::function_of_one>> {};
struct callee : peg::sor<function_name, name> {};

template <char... Chars>
struct key : token<peg::keyword<Chars...>> {};

// Numbers and strings

struct exponent
    : peg::seq<peg::one<'e', 'E'>, peg::opt<peg::one<'+', '-'>>, peg::plus<peg::digit>> {};
struct digits
    : peg::sor<peg::seq<peg::plus<peg::digit>, peg::opt<peg::one<'.'>, peg::star<peg::digit>>>,
               peg::seq<peg::one<'.'>, peg::plus<peg::digit>>> {};
struct number : token<digits, peg::opt<exponent>> {};
struct escape : peg::seq<peg::one<'\\'>, peg::any> {};
struct string_text : peg::star<peg::sor<escape, peg::not_one<'"', '\\'>>> {};
struct string_end : peg::one<'"'> {};
struct string : token<peg::if_must<peg::one<'"'>, string_text, string_end>> {};

// Expressions. Comparisons need parentheses, so that '>' closes a vector.

struct sum;
struct logic;
struct items;
struct rvalue;
struct directive;
struct comma : mark<','> {};
struct open_paren : mark<'('> {};
struct close_paren : mark<')'> {};
struct open_bracket : mark<'['> {};
struct close_bracket : mark<']'> {};
struct open_angle : mark<'<'> {};
struct close_angle : mark<'>'> {};
struct open_brace : mark<'{'> {};
struct close_brace : mark<'}'> {};
struct equals : mark<'='> {};
struct semicolon : mark<';'> {};

struct expression : peg::seq<sum> {};
struct operand : peg::seq<sum> {};  // after an operator, a bracket or '<': it must be there
struct parenthesis : peg::if_must<open_paren, logic, close_paren> {};
struct separator : peg::sor<comma, semicolon> {};
struct vector_comma : comma {};
struct vector_item : peg::sor<directive, sum, vector_comma> {};
struct vector_items : peg::star<vector_item> {};
struct vector : peg::if_must<open_angle, vector_items, close_angle> {};
struct argument : peg::seq<rvalue> {};
struct arguments : peg::opt<argument, peg::star<peg::opt<comma>, argument>> {};
struct only_argument : peg::seq<logic> {};
struct call
    : peg::sor<peg::seq<function_of_one, peg::if_must<open_paren, only_argument, close_paren>>,
               peg::seq<callee, peg::if_must<open_paren, arguments, close_paren>>> {};
struct variable : name {};
struct index;
struct element_of : peg::seq<variable, peg::star<index>> {};
struct primary : peg::sor<number, string, vector, parenthesis, call, constant, element_of> {};
struct member_name
    : peg::sor<key<'x'>, key<'y'>, key<'z'>, key<'u'>, key<'v'>, key<'t'>, key<'r', 'e', 'd'>,
               key<'g', 'r', 'e', 'e', 'n'>, key<'b', 'l', 'u', 'e'>,
               key<'f', 'i', 'l', 't', 'e', 'r'>, key<'t', 'r', 'a', 'n', 's', 'm', 'i', 't'>,
               key<'g', 'r', 'a', 'y'>> {};
struct member : peg::seq<mark<'.'>, member_name> {};
struct index : peg::if_must<open_bracket, operand, close_bracket> {};
struct postfix : peg::seq<primary, peg::star<member>> {};
struct sign : peg::sor<mark<'-'>, mark<'+'>, token<peg::one<'!'>, peg::not_at<peg::one<'='>>>> {};
struct unary : peg::seq<peg::star<sign>, postfix> {};
struct factor : unary {};
struct product_operator : peg::sor<mark<'*'>, mark<'/'>> {};
struct product : peg::seq<unary, peg::star<peg::if_must<product_operator, factor>>> {};
struct term : product {};
struct sum_operator : peg::sor<mark<'+'>, mark<'-'>> {};
struct sum : peg::seq<product, peg::star<peg::if_must<sum_operator, term>>> {};
struct relation_operator : token<peg::sor<peg::string<'<', '='>, peg::string<'>', '='>,
                                          peg::string<'!', '='>, peg::one<'=', '<', '>'>>> {};
struct relation : peg::seq<sum, peg::star<peg::if_must<relation_operator, operand>>> {};
struct compared : relation {};
struct boolean_operator : peg::sor<mark<'&'>, mark<'|'>> {};
struct boolean : peg::seq<relation, peg::star<peg::if_must<boolean_operator, compared>>> {};
struct colon : mark<':'> {};
struct choice_values : peg::if_must<mark<'?'>, logic, colon, logic> {};
struct choice : peg::seq<boolean, peg::opt<choice_values>> {};
struct logic : choice {};

// Values on the right of '=', in calls and in arrays

struct raw_brace;
struct raw_string : peg::seq<peg::one<'"'>, string_text, peg::one<'"'>> {};
struct raw_text
    : peg::star<peg::sor<line_comment, block_comment, raw_string, raw_brace, peg::not_one<'}'>>> {};
struct raw_close : peg::one<'}'> {};
struct raw_brace : peg::if_must<peg::one<'{'>, raw_text, raw_close> {};
struct parameter : identifier {};
struct parameters : peg::opt<parameter, peg::star<peg::opt<comma>, parameter>, peg::opt<comma>> {};
struct raster_size : peg::seq<digits, spacing, comma, digits, spacing> {
};  // of a height_field's function
struct function_head
    : peg::seq<key<'f', 'u', 'n', 'c', 't', 'i', 'o', 'n'>,
               peg::opt<peg::sor<peg::seq<open_paren, parameters, close_paren>, raster_size>>,
               peg::at<open_brace>> {};
struct function : peg::if_must<function_head, token<raw_brace>> {};
struct array_init;
struct element : peg::sor<array_init, rvalue> {};
struct array_init : peg::if_must<open_brace, peg::star<peg::sor<comma, element>>, close_brace> {};
struct array_size : index {};
struct array_sizes : peg::plus<array_size> {};
struct array
    : peg::seq<peg::if_must<key<'a', 'r', 'r', 'a', 'y'>, array_sizes>, peg::opt<array_init>> {};
struct color_operand : sum {};
struct color_channel : peg::seq<color_word, color_operand> {};  // after the first: transmit 0.5
struct color_phrase : peg::seq<peg::plus<color_word>, color_operand,
                               peg::star<peg::at<channel_name>, color_channel>> {};
struct block_word : token<peg::identifier, peg::at<spacing, peg::one<'{'>>> {};
struct block : peg::seq<block_word, peg::if_must<open_brace, items, close_brace>> {};
struct layered
    : peg::plus<peg::seq<peg::at<key<'t', 'e', 'x', 't', 'u', 'r', 'e'>, open_brace>, block>> {};
struct conditional;
struct value : peg::sor<conditional, array, function, layered, block, color_phrase, sum> {};
struct rvalue : value {};

// Directives

struct hash : token<peg::one<'#'>> {};
struct end : peg::seq<hash, key<'e', 'n', 'd'>> {};
struct target_index : index {};
struct target : peg::seq<name, peg::star<target_index>> {};
struct deprecated : peg::seq<key<'d', 'e', 'p', 'r', 'e', 'c', 'a', 't', 'e', 'd'>,
                             peg::opt<key<'o', 'n', 'c', 'e'>>, peg::opt<raw_string, spacing>> {};
struct declare
    : peg::if_must<peg::sor<key<'d', 'e', 'c', 'l', 'a', 'r', 'e'>, key<'l', 'o', 'c', 'a', 'l'>>,
                   peg::opt<deprecated>, target, equals, rvalue, peg::opt<semicolon>> {};
struct undef : peg::if_must<key<'u', 'n', 'd', 'e', 'f'>, name> {};
struct file_name : sum {};
struct include : peg::if_must<key<'i', 'n', 'c', 'l', 'u', 'd', 'e'>, file_name> {};
struct default_
    : peg::if_must<key<'d', 'e', 'f', 'a', 'u', 'l', 't'>, open_brace, items, close_brace> {};
struct version_number : sum {};
struct version : peg::if_must<key<'v', 'e', 'r', 's', 'i', 'o', 'n'>,
                              peg::opt<key<'u', 'n', 'o', 'f', 'f', 'i', 'c', 'i', 'a', 'l'>, name>,
                              version_number, peg::opt<semicolon>> {};
struct condition_open : open_paren {};
struct condition : peg::seq<condition_open, peg::must<logic, close_paren>> {};
struct elseif : peg::seq<hash, peg::if_must<key<'e', 'l', 's', 'e', 'i', 'f'>, condition, items>> {
};
struct else_ : peg::seq<hash, key<'e', 'l', 's', 'e'>, items> {};
// POV-Ray's own includes choose a block's word like this: #if (M) merge { #else union { #end ... }
struct split_head : peg::seq<key<'i', 'f'>, condition, block_word, open_brace, hash,
                             key<'e', 'l', 's', 'e'>, block_word, open_brace, end> {};
struct split_block : peg::if_must<split_head, items, close_brace> {};
struct if_tail : peg::seq<items, peg::star<elseif>, peg::opt<else_>> {};
struct if_ : peg::if_must<key<'i', 'f'>, condition, if_tail, end> {};
struct ifdef
    : peg::if_must<peg::sor<key<'i', 'f', 'd', 'e', 'f'>, key<'i', 'f', 'n', 'd', 'e', 'f'>>,
                   condition_open, target, close_paren, if_tail, end> {};
struct while_ : peg::if_must<key<'w', 'h', 'i', 'l', 'e'>, condition, items, end> {};
struct for_head : peg::seq<name, peg::opt<comma>, peg::must<operand>, peg::opt<comma>,
                           peg::must<operand>, peg::opt<peg::opt<comma>, sum>> {};
struct for_ : peg::if_must<key<'f', 'o', 'r'>, condition_open, for_head, close_paren, items, end> {
};
struct case_ : peg::seq<hash, peg::if_must<key<'c', 'a', 's', 'e'>, condition, items>> {};
struct range : peg::seq<hash, peg::if_must<key<'r', 'a', 'n', 'g', 'e'>, condition_open, logic,
                                           peg::opt<comma>, logic, close_paren, items>> {};
struct switch_ : peg::if_must<key<'s', 'w', 'i', 't', 'c', 'h'>, condition,
                              peg::star<peg::sor<case_, range>>, peg::opt<else_>, end> {};
struct break_ : key<'b', 'r', 'e', 'a', 'k'> {};
struct raw_word : peg::seq<peg::identifier> {};
struct raw_directive;
struct raw_end : peg::seq<hash, peg::keyword<'e', 'n', 'd'>> {};
struct raw_items : peg::star<peg::sor<raw_word, blank, line_comment, block_comment, raw_string,
                                      raw_directive, peg::seq<peg::not_at<raw_end>, peg::any>>> {};
struct raw_opener
    : peg::sor<peg::keyword<'i', 'f'>, peg::keyword<'i', 'f', 'd', 'e', 'f'>,
               peg::keyword<'i', 'f', 'n', 'd', 'e', 'f'>, peg::keyword<'w', 'h', 'i', 'l', 'e'>,
               peg::keyword<'f', 'o', 'r'>, peg::keyword<'s', 'w', 'i', 't', 'c', 'h'>,
               peg::keyword<'m', 'a', 'c', 'r', 'o'>> {};
struct raw_directive : peg::if_must<peg::seq<hash, raw_opener>, raw_items, raw_end> {};
struct macro_name : identifier {};
struct macro_body : raw_items {};
struct macro : peg::if_must<key<'m', 'a', 'c', 'r', 'o'>, macro_name, open_paren, parameters,
                            close_paren, macro_body, end> {};
struct message_word : peg::sor<key<'d', 'e', 'b', 'u', 'g'>, key<'w', 'a', 'r', 'n', 'i', 'n', 'g'>,
                               key<'e', 'r', 'r', 'o', 'r'>, key<'r', 'e', 'n', 'd', 'e', 'r'>,
                               key<'s', 't', 'a', 't', 'i', 's', 't', 'i', 'c', 's'>> {};
struct message_text : sum {};
struct message : peg::if_must<message_word, message_text> {};
struct file_io_word : peg::sor<key<'f', 'o', 'p', 'e', 'n'>, key<'f', 'c', 'l', 'o', 's', 'e'>,
                               key<'r', 'e', 'a', 'd'>, key<'w', 'r', 'i', 't', 'e'>> {};
struct file_io
    : peg::seq<
          file_io_word,
          peg::sor<peg::if_must<open_paren, arguments, close_paren>,
                   peg::seq<name, peg::opt<sum>,
                            peg::opt<peg::sor<key<'r', 'e', 'a', 'd'>, key<'w', 'r', 'i', 't', 'e'>,
                                              key<'a', 'p', 'p', 'e', 'n', 'd'>>>>>> {};
struct closing_word
    : peg::sor<peg::keyword<'e', 'n', 'd'>, peg::keyword<'e', 'l', 's', 'e'>,
               peg::keyword<'e', 'l', 's', 'e', 'i', 'f'>, peg::keyword<'c', 'a', 's', 'e'>,
               peg::keyword<'r', 'a', 'n', 'g', 'e'>> {};
struct known_directive : peg::failure {};
struct bad_directive : peg::if_must<peg::not_at<closing_word>, known_directive> {};
struct opening_word : peg::sor<peg::keyword<'i', 'f'>, peg::keyword<'i', 'f', 'd', 'e', 'f'>,
                               peg::keyword<'i', 'f', 'n', 'd', 'e', 'f'>,
                               peg::keyword<'s', 'w', 'i', 't', 'c', 'h'>,
                               peg::keyword<'i', 'n', 'c', 'l', 'u', 'd', 'e'>> {};
struct conditional : peg::seq<peg::at<hash, opening_word>, directive> {};
struct directive
    : peg::seq<hash,
               peg::sor<declare, split_block, if_, ifdef, while_, for_, switch_, break_, macro,
                        include, undef, default_, version, message, file_io, bad_directive>> {};

// Items

struct map_entry : peg::if_must<open_bracket, items, close_bracket> {};
struct item : peg::sor<directive, block, function, map_entry, array, expression, word, separator> {
};
struct items : peg::star<item> {};
struct byte_order_mark : peg::string<'\xEF', '\xBB', '\xBF'> {};
struct end_of_file : peg::eof {};
struct file : peg::seq<peg::opt<byte_order_mark>, spacing, items, peg::must<end_of_file>> {};

}  // namespace meniscus::grammar
