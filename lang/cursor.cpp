#include "lang/cursor.hpp"

#include <fmt/format.h>

#include <cmath>

#include "grammar/words.hpp"
#include "lang/directives.hpp"
#include "lang/evaluate.hpp"
#include "lang/stack.hpp"
#include "lang/suggest.hpp"

namespace meniscus::lang {

Cursor::Cursor(Session& session, const ast::Items& items, const Span& whole, std::string_view block)
    : session_(session), whole_(whole), block_(block) {
    if (stack_is_nearly_full()) throw SourceError(whole, "nested too deep");
    Frame frame;
    frame.items = &items;
    push(std::move(frame));
}

Cursor::Cursor(Session& session, const ast::Block& block, const Span& whole)
    : Cursor(session, block.items, whole, block.word) {}

const ast::Item* Cursor::peek() {
    while (!frames_.empty()) {
        auto& frame = frames_.back();
        if (frame.next == frame.items->size()) {
            finish_frame();
            continue;
        }
        const auto& item = (*frame.items)[frame.next];
        switch (item.node.index()) {
            case 0: {  // an expression: perhaps a macro's call
                const auto* macro = macro_called_by(session_, item);
                if (!macro) return &item;
                ++frame.next;
                const MacroValue called = *macro;
                enter_macro_call(session_, called,
                                 std::get<ast::Call>(std::get<ast::Expression>(item.node).node),
                                 item.span);
                Frame inner;
                inner.kind = Frame::Kind::macro;
                inner.items = &session_.library.body(called.macro->body).items;
                push(std::move(inner));
                break;
            }
            case 1:
            case 2:
            case 3:
            case 4:
            case 5:
            case 6:
                return &item;
            default:
                ++frame.next;
                if (!splice(item)) execute(session_, item);
        }
    }
    return nullptr;
}

void Cursor::advance() {
    auto& frame = frames_.back();
    if (const auto* word = std::get_if<ast::Word>(&(*frame.items)[frame.next].node))
        last_word_ = word->word;
    ++frame.next;
}

void Cursor::finish_frame() {
    auto& frame = frames_.back();
    switch (frame.kind) {
        case Frame::Kind::while_loop:
            session_.count_step(frame.span);
            if (evaluate_condition(session_, frame.while_loop->condition)) {
                frame.next = 0;
                return;
            }
            break;
        case Frame::Kind::for_loop: {
            session_.count_step(frame.span);
            const auto* value = frame.counter->get<double>();
            if (!value)
                throw SourceError(frame.span,
                                  fmt::format("'{}' is no longer a number", frame.for_loop->name));
            *frame.counter = Value{*value + frame.step};
            if (for_continues(frame, frame.span)) {
                frame.next = 0;
                return;
            }
            break;
        }
        case Frame::Kind::switch_:
            if (++frame.arm < frame.switch_->arms.size()) {  // falls through
                frame.items = &frame.switch_->arms[frame.arm].items;
                frame.next = 0;
                return;
            }
            break;
        case Frame::Kind::macro:
        case Frame::Kind::file:
            session_.leave();
            break;
        case Frame::Kind::items:
            break;
    }
    frames_.pop_back();
}

Span Cursor::span() {
    if (const auto* item = peek()) return item->span;
    Span end = whole_;
    if (end.end > end.begin) --end.end;  // the closing brace
    end.begin = end.end;
    if (whole_.end > whole_.begin) ++end.end;
    return end;
}

std::string_view Cursor::word() {
    const auto* item = peek();
    const auto* word = item ? std::get_if<ast::Word>(&item->node) : nullptr;
    return word ? word->word : std::string_view{};
}

bool Cursor::accept(std::string_view wanted) {
    if (word() != wanted) return false;
    advance();
    return true;
}

bool Cursor::accept_comma() {
    const auto* item = peek();
    const auto* separator = item ? std::get_if<ast::Separator>(&item->node) : nullptr;
    if (!separator || separator->mark != ',') return false;
    advance();
    return true;
}

bool Cursor::accept_semicolon() {
    const auto* item = peek();
    const auto* separator = item ? std::get_if<ast::Separator>(&item->node) : nullptr;
    if (!separator || separator->mark != ';') return false;
    advance();
    return true;
}

const ast::Block* Cursor::block() {
    const auto* item = peek();
    return item ? std::get_if<ast::Block>(&item->node) : nullptr;
}

const ast::MapEntry* Cursor::map_entry() {
    const auto* item = peek();
    return item ? std::get_if<ast::MapEntry>(&item->node) : nullptr;
}

const ast::Expression* Cursor::expression() {
    const auto* item = peek();
    return item ? std::get_if<ast::Expression>(&item->node) : nullptr;
}

const Value* Cursor::declared() {
    const auto* node = expression();
    const auto* variable = node ? std::get_if<ast::Variable>(&node->node) : nullptr;
    return variable ? find_variable(session_, *variable, node->span) : nullptr;
}

void Cursor::skip_rest() {
    while (peek()) advance();
}

void Cursor::expect_end() {
    if (peek()) fail_unknown();
}

std::string Cursor::describe_next() {
    const auto* item = peek();
    if (!item)
        return whole_.text().ends_with('}')   ? "'}'"
               : whole_.text().ends_with(')') ? "')'"
                                              : "the end";
    auto text = item->span.text();
    if (const auto* b = std::get_if<ast::Block>(&item->node)) text = b->word;
    const bool cut = text.size() > 40;
    return fmt::format("'{}{}'", text.substr(0, 40), cut ? "..." : "");
}

void Cursor::fail_expected(std::string_view what) {
    const auto at = span();
    const auto found = describe_next();
    if (!last_word_.empty())
        throw SourceError(at,
                          fmt::format("expected {} after '{}', found {}", what, last_word_, found));
    if (block_.empty()) throw SourceError(at, fmt::format("expected {}, found {}", what, found));
    throw SourceError(at, fmt::format("expected {} in '{}', found {}", what, block_, found));
}

void Cursor::fail_unknown() {
    auto at = span();
    const auto* item = peek();
    const auto in = block_ == "scene" ? std::string{} : fmt::format(" in '{}'", block_);
    std::string_view name = word();
    if (const auto* b = block()) {
        name = b->word;
        at = b->word_span;
    }
    if (const auto* node = expression()) {
        if (const auto* variable = std::get_if<ast::Variable>(&node->node)) {
            if (const auto* value = find_variable(session_, *variable, node->span)) {
                throw SourceError(at, fmt::format("'{}' is {}, which cannot stand here{}",
                                                  variable->name, kind_of(*value), in));
            }
            name = variable->name;
        }
        if (name.empty()) {
            throw SourceError(at, fmt::format("unexpected value {}{}", describe_next(), in));
        }
    }
    if (name.empty())
        throw SourceError(at, fmt::format("unexpected {}{}", item ? describe_next() : "end", in));
    if (grammar::is_reserved(name))
        throw SourceError(at, fmt::format("'{}' cannot stand here{}", name, in));
    auto names = session_.symbols.names();
    for (const auto known : grammar::reserved_words()) names.emplace_back(known);
    throw SourceError(at, fmt::format("unknown word '{}'{}{}", name, in, suggestion(name, names)));
}

}  // namespace meniscus::lang
