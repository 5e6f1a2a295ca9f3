#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lang/source.hpp"

namespace meniscus::lang {

/// What a node of the syntax tree was spelled as: the grammar's rules that carry meaning.
enum class Kind : std::uint8_t {
    none,
    file,
    number,
    string,
    vector,
    call,
    callee,
    argument,
    constant,
    variable_name,
    element_of,
    index,
    member_name,
    postfix,
    sign,
    unary,
    product,
    sum,
    relation,
    boolean,
    choice,
    operator_,
    separator,
    word,
    block,
    block_word,
    function,
    map_entry,
    array,
    array_size,
    array_init,
    element,
    items,
    value,
    declare,
    semicolon,
    target,
    name,
    undef,
    include,
    default_,
    version,
    condition_end,
    elseif,
    else_,
    if_,
    split_block,
    ifdef,
    while_,
    for_,
    switch_,
    case_,
    range,
    break_,
    macro,
    macro_body,
    parameter,
    message,
    message_word,
    file_io,
};

/// A node and, right behind it in the list, its `size - 1` descendants in the order of the text.
struct SyntaxNode {
    Kind kind;
    std::uint32_t begin, end;
    std::uint32_t size;
};

/// The syntax tree of a text as one flat list in the order of the text. Throws SourceError.
std::vector<SyntaxNode> parse_syntax(const Span& text);

}  // namespace meniscus::lang
