#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lang/source.hpp"

/// What a scene file says, as a tree. Texts are views into the source.
namespace meniscus::lang::ast {

struct Expression;
struct Item;
using Expressions = std::vector<Expression>;
using Items = std::vector<Item>;

// Expressions

struct Number {
    double value;
};
struct Text {
    std::string value;     // escapes resolved
    std::string_view raw;  // as written, for file names
};
struct Constant {
    std::string_view word;
};
struct Vector {
    Items items;  // expressions, commas and directives
};
struct Call {
    std::string_view callee;
    std::vector<Items> arguments;
};
struct Variable {
    std::string_view name;
    Expressions indices;
};
/// a + b - c: one level of precedence, from left to right. `operators` has one fewer.
struct Chain {
    Expressions operands;
    std::vector<std::string_view> operators;
};
struct Signed {
    std::string signs;  // from left to right
    std::unique_ptr<Expression> operand;
};
struct Members {
    std::unique_ptr<Expression> of;
    std::vector<std::string_view> names;
};
struct Choice {
    Expressions parts;  // condition, yes, no
};
struct Expression {
    std::variant<Number, Text, Constant, Vector, Call, Variable, Chain, Signed, Members, Choice>
        node;
    Span span;
};

// Items: what blocks, files and macros are lists of

struct Word {
    std::string_view word;
};
struct Separator {
    char mark;
};
struct Block {
    std::string_view word;
    Items items;
    Span word_span;
};
struct MapEntry {
    Items items;
};
struct Function {};  // its text is the span's
struct Array {
    Expressions sizes;
    struct Element {
        std::variant<Items, std::vector<Element>> value;
        Span span;
    };
    std::vector<Element> elements;
    bool has_elements = false;
};

// Directives

struct Target {
    Variable variable;
    Span span;
};
struct Declare {
    Target target;
    Items value;
    bool local, closed;  // `closed`: a semicolon follows
};
struct Undef {
    std::string_view name;
};
struct Include {
    Expression file;
};
struct Default {
    Items items;
};
struct Version {
    Expression number;
};
struct If {
    struct Branch {
        std::variant<Expression, Target> condition;  // a target is asked whether it is declared
        bool negated = false;
        Items items;
    };
    std::vector<Branch> branches;
    Items otherwise;
};
struct While {
    Expression condition;
    Items items;
};
struct For {
    std::string_view name;
    Expressions bounds;  // first, last and perhaps step
    Items items;
};
struct Switch {
    struct Arm {
        Expressions values;  // one for #case, two for #range, none for #else
        Items items;
    };
    std::unique_ptr<Expression> value;
    std::vector<Arm> arms;
};
struct Break {};
struct Macro {
    std::string_view name;
    std::vector<std::string_view> parameters;
    Span body;  // parsed when first called
};
struct Message {
    std::string_view word;
    Expression text;
};
struct FileIo {
    std::string_view word;
};

struct Item {
    using Node =
        std::variant<Expression, Word, Separator, Block, MapEntry, Function, std::unique_ptr<Array>,
                     std::unique_ptr<Declare>, Undef, std::unique_ptr<Include>, Default,
                     std::unique_ptr<Version>, std::unique_ptr<If>, std::unique_ptr<While>,
                     std::unique_ptr<For>, std::unique_ptr<Switch>, Break, std::unique_ptr<Macro>,
                     std::unique_ptr<Message>, FileIo>;
    Node node;
    Span span;
};

/// One parsed file, or one macro's body.
struct Program {
    Items items;
    Span end;  // an empty span where the text ends
};

}  // namespace meniscus::lang::ast
