#include "lang/evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grammar/words.hpp"
#include "lang/cursor.hpp"
#include "lang/functions.hpp"
#include "lang/operators.hpp"
#include "lang/read_value.hpp"
#include "lang/stack.hpp"
#include "lang/suggest.hpp"

namespace meniscus::lang {
namespace {

Vector axis(int i) {
    Vector v;
    v.size = i < 3 ? 3 : 4;
    v.at[static_cast<std::size_t>(i)] = 1.0;
    return v;
}

Value constant(Session& session, std::string_view word) {
    if (word == "x" || word == "u") return {axis(0)};
    if (word == "y" || word == "v") return {axis(1)};
    if (word == "z") return {axis(2)};
    if (word == "t") return {axis(3)};
    if (word == "pi") return {std::numbers::pi};
    if (word == "true" || word == "on" || word == "yes") return {1.0};
    if (word == "version") return {session.version.value_or(3.7)};
    if (word == "image_width") return {static_cast<double>(session.options.image_width)};
    if (word == "image_height") return {static_cast<double>(session.options.image_height)};
    if (word == "frame_number" || word == "initial_frame" || word == "final_frame") return {1.0};
    return {0.0};  // false, off, no, clock, clock_delta, clock_on, now
}

Value vector(Session& session, const ast::Vector& node, const Span& span) {
    Vector result;
    result.size = 0;
    Cursor cursor(session, node.items, span, "vector");
    while (const auto* item = cursor.peek()) {
        if (const auto* expression = std::get_if<ast::Expression>(&item->node)) {
            const auto value = evaluate(session, *expression);
            if (value.get<Refusal>()) return value;
            if (result.size == 5)
                throw SourceError(expression->span, "a vector has at most five components");
            result.at[static_cast<std::size_t>(result.size++)] = to_number(value, expression->span);
            cursor.advance();
            cursor.accept_comma();
        } else {
            throw SourceError(item->span, "expected a number in the vector");
        }
    }
    if (result.size < 2) throw SourceError(span, "a vector has two to five components");
    return {result};
}

double member(const Value& value, std::string_view name, const Span& span) {
    const bool of_color = name.size() > 1;
    const auto v = to_vector(value, span);
    if (name == "gray") return 0.297 * v.at[0] + 0.589 * v.at[1] + 0.114 * v.at[2];
    int i = 0;
    if (name == "y" || name == "v" || name == "green") i = 1;
    if (name == "z" || name == "blue") i = 2;
    if (name == "t" || name == "filter") i = 3;
    if (name == "transmit") i = 4;
    if (i >= v.size && !of_color) {
        throw SourceError(span,
                          fmt::format("a vector of {} components has no '.{}'", v.size, name));
    }
    return v.at[static_cast<std::size_t>(i)];
}

Value call_macro(Session& session, const MacroValue& macro, const ast::Call& node,
                 const Span& span) {
    enter_macro_call(session, macro, node, span);
    const auto& body = session.library.body(macro.macro->body);
    Cursor cursor(session, body.items, body.end, "macro");
    if (cursor.at_end()) {
        throw SourceError(span, fmt::format("macro '{}' gives no value here", macro.macro->name));
    }
    auto value = read_value(cursor);
    if (!cursor.at_end()) {
        throw SourceError(cursor.span(),
                          fmt::format("macro '{}' is used as a value, so it must give one value "
                                      "only; put a sum in parentheses",
                                      macro.macro->name));
    }
    session.leave();
    return value;
}

Value is_defined(Session& session, const ast::Call& node, const Span& span) {
    if (node.arguments.size() == 1 && node.arguments[0].size() == 1) {
        if (const auto* e = std::get_if<ast::Expression>(&node.arguments[0][0].node)) {
            if (const auto* name = std::get_if<ast::Variable>(&e->node)) {
                return {session.symbols.find(name->name) ? 1.0 : 0.0};
            }
        }
    }
    throw SourceError(span, "expected a name in defined()");
}

Value call(Session& session, const ast::Call& node, const Span& span) {
    const bool builtin = grammar::is_function(node.callee);
    if (!builtin) {
        const auto slot = session.symbols.find(node.callee);
        if (!slot) {
            auto names = session.symbols.names();
            for (const auto word : grammar::reserved_words()) {
                if (grammar::is_function(word)) names.emplace_back(word);
            }
            Span name = span;
            name.end = name.begin + static_cast<std::uint32_t>(node.callee.size());
            throw SourceError(name, fmt::format("unknown function or macro '{}'{}", node.callee,
                                                suggestion(node.callee, names)));
        }
        if (const auto* macro = slot->item<MacroValue>())
            return call_macro(session, *macro, node, span);
        if (const auto* refusal = slot->get<Refusal>()) return {*refusal};
        throw SourceError(span,
                          fmt::format("'{}' is {}, not a macro", node.callee, kind_of(*slot)));
    }
    if (node.callee == "defined") return is_defined(session, node, span);
    std::vector<Argument> arguments;
    for (const auto& items : node.arguments) {
        Cursor cursor(session, items, span, "call");
        const auto at = cursor.span();
        auto value = read_value(cursor);
        cursor.expect_end();
        if (value.get<Refusal>()) return value;
        arguments.push_back({std::move(value), at});
    }
    return call_function(session, node.callee, arguments, span);
}

Value variable(Session& session, const ast::Variable& node, const Span& span) {
    const auto* value = find_variable(session, node, span);
    if (!value) {
        auto names = session.symbols.names();
        for (const auto word : grammar::reserved_words()) names.emplace_back(word);
        throw SourceError(
            span, fmt::format("unknown name '{}'{}", node.name, suggestion(node.name, names)));
    }
    if (!value->is_set()) {
        throw SourceError(span,
                          fmt::format("this element of array '{}' has no value yet", node.name));
    }
    return *value;
}

Value chain(Session& session, const ast::Chain& node, const Span& span) {
    auto result = evaluate(session, node.operands.front());
    for (std::size_t i = 0; i < node.operators.size(); ++i) {
        const auto right = evaluate(session, node.operands[i + 1]);
        result = apply_operator(session, node.operators[i], result, right, span);
    }
    return result;
}

Value signs(Session& session, const ast::Signed& node, const Span& span) {
    auto value = evaluate(session, *node.operand);
    for (auto sign = node.signs.rbegin(); sign != node.signs.rend(); ++sign)
        value = apply_sign(*sign, value, span);
    return value;
}

}  // namespace

void enter_macro_call(Session& session, const MacroValue& macro, const ast::Call& node,
                      const Span& span) {
    const auto& parameters = macro.macro->parameters;
    if (parameters.size() != node.arguments.size()) {
        throw SourceError(span,
                          fmt::format("macro '{}' takes {} argument{}, not {}", macro.macro->name,
                                      parameters.size(), parameters.size() == 1 ? "" : "s",
                                      node.arguments.size()));
    }
    std::vector<Slot> slots;
    for (const auto& items : node.arguments) {
        if (items.size() == 1) {  // a plain name is passed by reference
            const auto* expression = std::get_if<ast::Expression>(&items[0].node);
            const auto* name = expression ? std::get_if<ast::Variable>(&expression->node) : nullptr;
            if (name && name->indices.empty()) {
                if (auto slot = session.symbols.find(name->name)) {
                    slots.push_back(std::move(slot));
                    continue;
                }
            }
        }
        Cursor cursor(session, items, span, "call");
        slots.push_back(std::make_shared<Value>(read_value(cursor)));
        cursor.expect_end();
    }
    session.enter_macro(macro.macro->name, span);
    for (std::size_t i = 0; i < slots.size(); ++i)
        session.symbols.bind(parameters[i], std::move(slots[i]));
}

const MacroValue* macro_called_by(Session& session, const ast::Item& item) {
    const auto* expression = std::get_if<ast::Expression>(&item.node);
    const auto* call = expression ? std::get_if<ast::Call>(&expression->node) : nullptr;
    if (!call) return nullptr;
    const auto slot = session.symbols.find(call->callee);
    return slot ? slot->item<MacroValue>() : nullptr;
}

Value evaluate(Session& session, const ast::Expression& expression) {
    if (stack_is_nearly_full()) throw SourceError(expression.span, "nested too deep");
    const auto& span = expression.span;
    const auto& node = expression.node;
    if (const auto* n = std::get_if<ast::Number>(&node)) return {n->value};
    if (const auto* n = std::get_if<ast::Variable>(&node)) return variable(session, *n, span);
    if (const auto* n = std::get_if<ast::Vector>(&node)) return vector(session, *n, span);
    if (const auto* n = std::get_if<ast::Constant>(&node)) return constant(session, n->word);
    if (const auto* n = std::get_if<ast::Signed>(&node)) return signs(session, *n, span);
    if (const auto* n = std::get_if<ast::Chain>(&node)) return chain(session, *n, span);
    if (const auto* n = std::get_if<ast::Call>(&node)) return call(session, *n, span);
    if (const auto* n = std::get_if<ast::Text>(&node)) return {n->value};
    if (const auto* n = std::get_if<ast::Members>(&node)) {
        auto value = evaluate(session, *n->of);
        for (const auto name : n->names) {
            if (value.get<Refusal>()) return value;
            value = {member(value, name, span)};
        }
        return value;
    }
    const auto& choice = std::get<ast::Choice>(node);
    return evaluate(session, choice.parts[evaluate_condition(session, choice.parts[0]) ? 1 : 2]);
}

double evaluate_number(Session& session, const ast::Expression& expression) {
    return to_number(evaluate(session, expression), expression.span);
}
std::string evaluate_string(Session& session, const ast::Expression& expression) {
    return to_string(evaluate(session, expression), expression.span);
}
bool evaluate_condition(Session& session, const ast::Expression& expression) {
    return is_true(evaluate_number(session, expression));
}

std::size_t element_place(Session& session, const ArrayValue& array,
                          const ast::Expressions& indices, std::size_t& used) {
    std::size_t place = 0;
    for (const auto size : array.sizes) {
        if (used >= indices.size()) {
            throw SourceError(indices.back().span,
                              fmt::format("the array has {} dimensions: an index is missing",
                                          array.sizes.size()));
        }
        const auto& index = indices[used++];
        const double number = std::trunc(evaluate_number(session, index));
        if (!(number >= 0.0 && number < static_cast<double>(size))) {
            throw SourceError(
                index.span,
                fmt::format("index {} is outside the array, which has {} elements", number, size));
        }
        place = place * size + static_cast<std::size_t>(number);
    }
    return place;
}

const Value* find_variable(Session& session, const ast::Variable& variable, const Span& span) {
    const auto slot = session.symbols.find(variable.name);
    if (!slot) return nullptr;
    const Value* value = slot.get();
    std::size_t used = 0;
    while (used < variable.indices.size()) {
        const auto* array = value->get<std::shared_ptr<ArrayValue>>();
        if (!array) {
            throw SourceError(span, fmt::format("'{}' is {}, which has no elements", variable.name,
                                                kind_of(*value)));
        }
        value = &(*array)->elements[element_place(session, **array, variable.indices, used)];
    }
    if (const auto* object = value->item<ObjectItem>())
        session.object_use.read(object->declared_at);
    return value;
}

}  // namespace meniscus::lang
