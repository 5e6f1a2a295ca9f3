#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lang/ast.hpp"
#include "lang/session.hpp"
#include "lang/value.hpp"

namespace meniscus::lang {

/// Walks the items of a block, of a file or of a macro. Directives met on the way are carried out,
/// so that their items stand where they stood: the readers of blocks see none of `#if`, `#while` or
/// macro calls.
class Cursor {
public:
    /// `whole` is the text that the items came from, its end where "found '}'" points; `block`
    /// names it in messages.
    Cursor(Session& session, const ast::Items& items, const Span& whole, std::string_view block);
    Cursor(Session& session, const ast::Block& block, const Span& whole);
    Cursor(const Cursor&) = delete;
    Cursor& operator=(const Cursor&) = delete;

    Session& session() const { return session_; }
    std::string_view block_word() const { return block_; }

    /// The next item, never a directive; null at the end.
    const ast::Item* peek();
    void advance();
    bool at_end() { return peek() == nullptr; }
    /// Where the next item stands, or the end.
    Span span();

    /// The next item if it is a bare word, else empty.
    std::string_view word();
    bool accept(std::string_view word);
    bool accept_comma();
    bool accept_semicolon();
    /// The next item if it is a block.
    const ast::Block* block();
    const ast::MapEntry* map_entry();
    /// The next item if it is an expression.
    const ast::Expression* expression();
    /// The next item if it is nothing but a declared name, evaluated; the cursor stays.
    const Value* declared();

    // Values: each takes an optional comma after itself.
    Value value();
    double number();
    bool flag();
    geom::Vec3 vector();
    geom::Vec2 vector2();
    Vector color();
    std::string string();
    /// A word followed by a value or by nothing: `hollow`, `hollow off`.
    bool flag_or_true();

    void skip_rest();
    void expect_end();
    /// "expected a number after 'phong', found '}'".
    [[noreturn]] void fail_expected(std::string_view what);
    /// "unknown word 'xyz' in 'finish'; did you mean ...".
    [[noreturn]] void fail_unknown();

private:
    struct Frame {
        enum class Kind { items, while_loop, for_loop, switch_, macro, file };
        Kind kind = Kind::items;
        const ast::Items* items = nullptr;
        std::size_t next = 0;
        const ast::While* while_loop = nullptr;
        const ast::For* for_loop = nullptr;
        const ast::Switch* switch_ = nullptr;
        std::size_t arm = 0;
        Span span{};
        double last = 0.0, step = 0.0;
        Slot counter{};
    };

    void push(Frame frame) { frames_.push_back(std::move(frame)); }
    void finish_frame();
    bool splice(const ast::Item& item);
    void splice_if(const ast::If& node);
    void splice_for(const ast::For& node, const Span& span);
    void splice_switch(const ast::Switch& node, const Span& span);
    void splice_include(const ast::Include& node);
    bool for_continues(const Frame& frame, const Span& span);
    void break_loop(const Span& span);
    std::string describe_next();

    Session& session_;
    Span whole_;
    std::string_view block_, last_word_;
    std::vector<Frame> frames_;
};

/// Evaluates the arguments, enters the macro's scope and binds its parameters.
void enter_macro_call(Session& session, const MacroValue& macro, const ast::Call& node,
                      const Span& span);
/// The macro if the item is nothing but a call of one.
const MacroValue* macro_called_by(Session& session, const ast::Item& item);

}  // namespace meniscus::lang
