#include "lang/directives.hpp"

#include <fmt/format.h>

#include "grammar/words.hpp"
#include "lang/cursor.hpp"
#include "lang/evaluate.hpp"
#include "lang/read_texture.hpp"
#include "lang/read_value.hpp"

namespace meniscus::lang {
namespace {

bool needs_semicolon(const Value& value) { return value.get<double>() || value.get<Vector>(); }

void check_semicolon(Session& session, const ast::Declare& node, const Value& value, bool closed,
                     const Span& span) {
    if (closed || !needs_semicolon(value)) return;
    const auto text =
        fmt::format("expected ';' after the value of '{}'", node.target.variable.name);
    Span end = span;
    end.begin = end.end > 0 ? end.end - 1 : 0;
    if (session.version.value_or(3.7) >= 3.5) throw SourceError(end, text);
    session.warn(end, text);
}

/// An object is called by the name under which it was declared.
Value named(Session& session, Value value, const ast::Target& target) {
    const auto* object = value.item<ObjectItem>();
    if (!object) return value;
    auto copy = *object;
    copy.name = target.variable.name;
    copy.declared_at = target.span;
    session.object_use.declare(copy.name, target.span);
    return make_item(std::move(copy));
}

std::shared_ptr<ArrayValue>& own_copy(std::shared_ptr<ArrayValue>& array) {
    if (array.use_count() > 1) array = std::make_shared<ArrayValue>(*array);
    return array;
}

void assign_element(Session& session, Slot slot, const ast::Target& target, Value value) {
    const auto& variable = target.variable;
    auto* place = slot.get();
    std::size_t used = 0;
    int depth = 0;
    while (used < variable.indices.size()) {
        auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&place->data);
        if (!array) {
            throw SourceError(target.span, fmt::format("'{}' is {}, which has no elements",
                                                       variable.name, kind_of(*place)));
        }
        const auto at = element_place(session, **array, variable.indices, used);
        auto& own = own_copy(*array);
        if (const auto* inner = value.get<std::shared_ptr<ArrayValue>>()) {
            own->depth = std::max(own->depth, (*inner)->depth + 1 + depth);
            if (own->depth > session.options.limits.nesting)
                throw SourceError(target.span, "arrays nested too deep");
        }
        ++depth;
        place = &own->elements[at];
    }
    if (place->is_set() && place->data.index() != value.data.index() && !place->get<Refusal>() &&
        !value.get<Refusal>()) {
        throw SourceError(target.span, fmt::format("an array holds values of one kind: {}, not {}",
                                                   kind_of(*place), kind_of(value)));
    }
    *place = std::move(value);
}

void declare(Session& session, const ast::Declare& node, const Span& span) {
    const auto& target = node.target;
    Cursor cursor(session, node.value, span, "#declare");
    auto value = read_value(cursor);
    const bool closed = cursor.accept_semicolon() || node.closed;
    cursor.expect_end();
    check_semicolon(session, node, value, closed, span);
    if (target.variable.indices.empty()) {
        auto slot = node.local ? session.symbols.declare_local(target.variable.name)
                               : session.symbols.declare(target.variable.name);
        *slot = named(session, std::move(value), target);
        return;
    }
    auto slot = session.symbols.find(target.variable.name);
    if (!slot)
        throw SourceError(target.span, fmt::format("unknown array '{}'", target.variable.name));
    assign_element(session, slot, target, std::move(value));
}

void message(Session& session, const ast::Message& node, const Span& span) {
    const auto text = evaluate_string(session, node.text);
    if (node.word == "error") throw SourceError(span, text);
    if (node.word == "warning") {
        session.warn(span, text);
    } else if (session.messages.size() + text.size() < session.options.limits.string_bytes) {
        session.messages += text;
    }
}

void set_default(Session& session, const ast::Default& node, const Span& span) {
    Cursor cursor(session, node.items, span, "#default");
    read_default(cursor);
}

void define_macro(Session& session, const std::unique_ptr<ast::Macro>& node, const Span& span) {
    if (grammar::is_reserved(node->name)) {
        throw SourceError(
            span,
            fmt::format("'{}' is a word of the language and cannot name a macro", node->name));
    }
    for (const auto parameter : node->parameters) {
        if (grammar::is_reserved(parameter)) {
            throw SourceError(
                span, fmt::format("'{}' is a word of the language and cannot name a parameter",
                                  parameter));
        }
    }
    *session.symbols.declare(node->name) = make_item(MacroValue{node.get(), span});
}

}  // namespace

void execute(Session& session, const ast::Item& item) {
    if (const auto* node = std::get_if<std::unique_ptr<ast::Declare>>(&item.node))
        return declare(session, **node, item.span);
    if (const auto* node = std::get_if<ast::Undef>(&item.node))
        return session.symbols.remove(node->name);
    if (const auto* node = std::get_if<ast::Default>(&item.node))
        return set_default(session, *node, item.span);
    if (const auto* node = std::get_if<std::unique_ptr<ast::Macro>>(&item.node))
        return define_macro(session, *node, item.span);
    if (const auto* node = std::get_if<std::unique_ptr<ast::Message>>(&item.node))
        return message(session, **node, item.span);
    if (const auto* node = std::get_if<std::unique_ptr<ast::Version>>(&item.node)) {
        session.version = evaluate_number(session, (*node)->number);
        return;
    }
    throw refuse({std::string(item.span.text().substr(0, item.span.text().find_first_of(" \t("))),
                  item.span,
                  {}});
}

const ParsedFile& open_include(Session& session, const ast::Include& node) {
    const auto& span = node.file.span;
    const auto* text = std::get_if<ast::Text>(&node.file.node);
    const auto name = text ? std::string(text->raw) : evaluate_string(session, node.file);
    if (!session.options.allow_files) throw FileError(span, "files cannot be included here");
    const auto found = session.library.find(name, Session::folder_of(span));
    if (!found)
        throw FileError(span, fmt::format("cannot find '{}' beside the scene, in the library paths "
                                          "or among POV-Ray's includes",
                                          name));
    if (found->other_case)
        session.warn(span,
                     fmt::format("there is no '{}': taking '{}'", name, found->path.string()));
    return session.library.load(found->path, span);
}

bool is_declared(Session& session, const ast::Target& target) {
    const auto slot = session.symbols.find(target.variable.name);
    if (!slot || target.variable.indices.empty()) return slot != nullptr;
    const auto* value = find_variable(session, target.variable, target.span);
    return value && value->is_set();
}

}  // namespace meniscus::lang
