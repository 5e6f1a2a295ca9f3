#include <fmt/format.h>

#include <cmath>

#include "lang/cursor.hpp"
#include "lang/directives.hpp"
#include "lang/evaluate.hpp"

/// The directives whose items take part in the walk: conditions, loops and included files.
namespace meniscus::lang {

bool Cursor::splice(const ast::Item& item) {
    if (const auto* node = std::get_if<std::unique_ptr<ast::If>>(&item.node)) {
        splice_if(**node);
    } else if (const auto* loop = std::get_if<std::unique_ptr<ast::While>>(&item.node)) {
        if (!evaluate_condition(session_, (*loop)->condition)) return true;
        Frame frame;
        frame.kind = Frame::Kind::while_loop;
        frame.items = &(*loop)->items;
        frame.while_loop = loop->get();
        frame.span = item.span;
        push(std::move(frame));
    } else if (const auto* for_loop = std::get_if<std::unique_ptr<ast::For>>(&item.node)) {
        splice_for(**for_loop, item.span);
    } else if (const auto* choice = std::get_if<std::unique_ptr<ast::Switch>>(&item.node)) {
        splice_switch(**choice, item.span);
    } else if (const auto* include = std::get_if<std::unique_ptr<ast::Include>>(&item.node)) {
        splice_include(**include);
    } else if (std::holds_alternative<ast::Break>(item.node)) {
        break_loop(item.span);
    } else {
        return false;
    }
    return true;
}

void Cursor::splice_if(const ast::If& node) {
    const ast::Items* chosen = &node.otherwise;
    for (const auto& branch : node.branches) {
        bool holds = false;
        if (const auto* target = std::get_if<ast::Target>(&branch.condition)) {
            holds = is_declared(session_, *target);
        } else {
            holds = evaluate_condition(session_, std::get<ast::Expression>(branch.condition));
        }
        if (holds != branch.negated) {
            chosen = &branch.items;
            break;
        }
    }
    if (chosen->empty()) return;
    Frame frame;
    frame.items = chosen;
    push(std::move(frame));
}

void Cursor::splice_for(const ast::For& node, const Span& span) {
    Frame frame;
    frame.kind = Frame::Kind::for_loop;
    frame.items = &node.items;
    frame.for_loop = &node;
    frame.span = span;
    const double first = evaluate_number(session_, node.bounds[0]);
    frame.last = evaluate_number(session_, node.bounds[1]);
    frame.step = node.bounds.size() > 2 ? evaluate_number(session_, node.bounds[2]) : 1.0;
    if (frame.step == 0.0 || std::isnan(frame.step))
        throw SourceError(node.bounds.back().span, "#for needs a step other than 0");
    frame.counter = session_.symbols.declare_local(node.name);
    *frame.counter = Value{first};
    if (for_continues(frame, span)) push(std::move(frame));
}

bool Cursor::for_continues(const Frame& frame, const Span&) {
    // the tolerance lets 0 to 1 by 0.1 run 11 times, as in POV-Ray
    const double i = *frame.counter->get<double>();
    const double past = (i - frame.last) * (frame.step > 0.0 ? 1.0 : -1.0);
    return past < 1e-10;
}

void Cursor::splice_switch(const ast::Switch& node, const Span& span) {
    const double value = evaluate_number(session_, *node.value);
    for (std::size_t i = 0; i < node.arms.size(); ++i) {
        const auto& arm = node.arms[i];
        bool holds = arm.values.empty();
        if (arm.values.size() == 1)
            holds = std::abs(value - evaluate_number(session_, arm.values[0])) < 1e-10;
        if (arm.values.size() == 2) {
            holds = value >= evaluate_number(session_, arm.values[0]) &&
                    value <= evaluate_number(session_, arm.values[1]);
        }
        if (!holds) continue;
        Frame frame;
        frame.kind = Frame::Kind::switch_;
        frame.switch_ = &node;
        frame.arm = i;
        frame.items = &arm.items;
        frame.span = span;
        push(std::move(frame));
        return;
    }
}

void Cursor::splice_include(const ast::Include& node) {
    const auto& file = open_include(session_, node);
    session_.enter_file(*file.source, node.file.span);
    Frame frame;
    frame.kind = Frame::Kind::file;
    frame.items = &file.program.items;
    push(std::move(frame));
}

void Cursor::break_loop(const Span& span) {
    while (!frames_.empty()) {
        const auto kind = frames_.back().kind;
        if (kind == Frame::Kind::macro || kind == Frame::Kind::file) break;
        if (frames_.size() == 1 && kind == Frame::Kind::items) break;
        frames_.pop_back();
        if (kind != Frame::Kind::items) return;
    }
    throw SourceError(span, "#break stands in no loop and no #switch");
}

}  // namespace meniscus::lang
