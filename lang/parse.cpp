#include "lang/parse.hpp"

#include "grammar/words.hpp"
#include "lang/diagnostic.hpp"
#include "lang/literals.hpp"
#include "lang/syntax_tree.hpp"

namespace meniscus::lang {
namespace {

using Node = std::uint32_t;

/// The syntax tree, walked once to make the program.
class TreeReader {
public:
    TreeReader(const Span& text, std::vector<SyntaxNode> nodes)
        : text_(text), nodes_(std::move(nodes)) {}

    ast::Program program() {
        const auto end = text_.end;
        return {items(first(0)), Span{text_.source, end, end}};
    }

private:
    Kind kind(Node n) const { return nodes_[n].kind; }
    Node first(Node n) const { return n + 1; }
    Node end(Node n) const { return n + nodes_[n].size; }
    Node next(Node n) const { return n + nodes_[n].size; }
    bool has_child(Node n) const { return nodes_[n].size > 1; }
    Span span(Node n) const { return {text_.source, nodes_[n].begin, nodes_[n].end}; }
    std::string_view text(Node n) const { return span(n).text(); }
    /// The node's text without what may follow in comments.
    std::string_view word(Node n) const {
        const auto all = text(n);
        std::size_t size = 0;
        while (size < all.size() && grammar::is_word_char(all[size])) ++size;
        return all.substr(0, size);
    }
    template <class Visit>
    void each_child(Node n, Visit visit) const {
        for (auto child = first(n); child < end(n); child = next(child)) visit(child);
    }

    // Expressions

    ast::Expression expression(Node n) const {
        switch (kind(n)) {
            case Kind::number:
                return {ast::Number{parse_number(text(n))}, span(n)};
            case Kind::string:
                return {parse_string(text(n)), span(n)};
            case Kind::constant:
                return {ast::Constant{word(n)}, word_span(n)};
            case Kind::vector:
                return {ast::Vector{children_as_items(n)}, span(n)};
            case Kind::call:
                return {call(n), span(n)};
            case Kind::element_of:
                return {variable(n), span(n)};
            case Kind::postfix:
                return {members(n), span(n)};
            case Kind::unary:
                return {signed_operand(n), span(n)};
            case Kind::choice:
                return {ast::Choice{children_as_expressions(n)}, span(n)};
            default:
                return {chain(n), span(n)};
        }
    }
    Span word_span(Node n) const {
        auto result = span(n);
        result.end = result.begin + static_cast<std::uint32_t>(word(n).size());
        return result;
    }
    ast::Expressions children_as_expressions(Node n) const {
        ast::Expressions result;
        each_child(n, [&](Node child) { result.push_back(expression(child)); });
        return result;
    }
    ast::Call call(Node n) const {
        ast::Call result{word(n), {}};
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::argument) result.arguments.push_back(argument(first(child)));
        });
        return result;
    }
    ast::Variable variable(Node n) const {
        ast::Variable result{word(n), {}};
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::index) result.indices.push_back(expression(first(child)));
        });
        return result;
    }
    ast::Members members(Node n) const {
        ast::Members result;
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::member_name) {
                result.names.push_back(word(child));
            } else {
                result.of = std::make_unique<ast::Expression>(expression(child));
            }
        });
        return result;
    }
    ast::Signed signed_operand(Node n) const {
        ast::Signed result;
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::sign) {
                result.signs.push_back(text(child).front());
            } else {
                result.operand = std::make_unique<ast::Expression>(expression(child));
            }
        });
        return result;
    }
    ast::Chain chain(Node n) const {
        ast::Chain result;
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::operator_) {
                const auto all = text(child);
                result.operators.push_back(all.substr(0, all.size() > 1 && all[1] == '=' ? 2 : 1));
            } else {
                result.operands.push_back(expression(child));
            }
        });
        return result;
    }

    // Items

    ast::Items items(Node n) const { return children_as_items(n); }
    ast::Items argument(Node n) const {
        if (kind(n) == Kind::value) return value(n);
        ast::Items result;
        result.push_back(item(n));
        return result;
    }
    ast::Items value(Node n) const { return children_as_items(n); }
    ast::Items children_as_items(Node n) const {
        ast::Items result;
        each_child(n, [&](Node child) { result.push_back(item(child)); });
        return result;
    }

    ast::Item item(Node n) const {
        const auto made = [&](ast::Item::Node node) { return ast::Item{std::move(node), span(n)}; };
        switch (kind(n)) {
            case Kind::word:
                return {ast::Word{word(n)}, word_span(n)};
            case Kind::separator:
                return {ast::Separator{text(n).front()}, span(n)};
            case Kind::block:
                return made(ast::Block{word(n), items(last_child(n)), word_span(n)});
            case Kind::map_entry:
                return made(ast::MapEntry{items(first(n))});
            case Kind::function:
                return made(ast::Function{});
            case Kind::array:
                return made(std::make_unique<ast::Array>(array(n)));
            case Kind::declare:
                return made(std::make_unique<ast::Declare>(declare(n)));
            case Kind::undef:
                return made(ast::Undef{word(first(n))});
            case Kind::include:
                return made(std::make_unique<ast::Include>(ast::Include{expression(first(n))}));
            case Kind::default_:
                return made(ast::Default{items(first(n))});
            case Kind::version:
                return made(std::make_unique<ast::Version>(ast::Version{version(n)}));
            case Kind::split_block:
                return made(std::make_unique<ast::If>(split_block(n)));
            case Kind::if_:
            case Kind::ifdef:
                return made(std::make_unique<ast::If>(if_(n)));
            case Kind::while_: {
                const auto condition = first(n);
                return made(std::make_unique<ast::While>(
                    ast::While{expression(condition), items(next(condition))}));
            }
            case Kind::for_:
                return made(std::make_unique<ast::For>(for_(n)));
            case Kind::switch_:
                return made(std::make_unique<ast::Switch>(switch_(n)));
            case Kind::break_:
                return made(ast::Break{});
            case Kind::macro:
                return made(std::make_unique<ast::Macro>(macro(n)));
            case Kind::message: {
                const auto name = first(n);
                return made(std::make_unique<ast::Message>(
                    ast::Message{word(name), expression(next(name))}));
            }
            case Kind::file_io:
                return made(ast::FileIo{word(n)});
            default:
                return {expression(n), span(n)};
        }
    }
    Node last_child(Node n) const {
        auto last = first(n);
        each_child(n, [&](Node child) { last = child; });
        return last;
    }

    ast::Array array(Node n) const {
        ast::Array result;
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::array_size) result.sizes.push_back(expression(first(child)));
            if (kind(child) == Kind::array_init) {
                result.has_elements = true;
                result.elements = elements(child);
            }
        });
        return result;
    }
    std::vector<ast::Array::Element> elements(Node n) const {
        std::vector<ast::Array::Element> result;
        each_child(n, [&](Node element) {
            const auto inner = first(element);
            if (kind(inner) == Kind::array_init) {
                result.push_back({elements(inner), span(element)});
            } else {
                result.push_back({value(inner), span(element)});
            }
        });
        return result;
    }

    ast::Target target(Node n) const {
        ast::Target result{{word(n), {}}, span(n)};
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::index)
                result.variable.indices.push_back(expression(first(child)));
        });
        return result;
    }
    ast::Declare declare(Node n) const {
        ast::Declare result{{}, {}, word(n) == "local", false};
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::target) result.target = target(child);
            if (kind(child) == Kind::value) result.value = value(child);
            if (kind(child) == Kind::semicolon) result.closed = true;
        });
        return result;
    }
    ast::Expression version(Node n) const {
        auto number = first(n);
        while (kind(number) == Kind::name) number = next(number);
        return expression(number);
    }

    ast::If if_(Node n) const {
        ast::If result;
        auto child = first(n);
        ast::If::Branch branch;
        if (kind(n) == Kind::ifdef) {
            branch.condition = target(child);
            branch.negated = word(n) == "ifndef";
        } else {
            branch.condition = expression(child);
        }
        child = next(child);
        branch.items = items(child);
        result.branches.push_back(std::move(branch));
        for (child = next(child); child < end(n); child = next(child)) {
            if (kind(child) == Kind::elseif) {
                const auto condition = first(child);
                result.branches.push_back({expression(condition), false, items(next(condition))});
            } else if (kind(child) == Kind::else_) {
                result.otherwise = items(first(child));
            }
        }
        return result;
    }
    /// Two blocks of the same items, to choose between.
    ast::If split_block(Node n) const {
        const auto condition = first(n), word1 = next(condition), word2 = next(word1),
                   inner = next(word2);
        constexpr int most_nested = 8;  // as each is read twice
        if (split_depth_ == most_nested) throw SourceError(span(n), "nested too deep");
        ++split_depth_;
        const auto one_block = [&](Node name) {
            ast::Items result;
            result.push_back({ast::Block{word(name), items(inner), word_span(name)}, span(n)});
            return result;
        };
        ast::If result;
        result.branches.push_back({expression(condition), false, one_block(word1)});
        result.otherwise = one_block(word2);
        --split_depth_;
        return result;
    }
    ast::For for_(Node n) const {
        ast::For result;
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::name) {
                result.name = word(child);
            } else if (kind(child) == Kind::items) {
                result.items = items(child);
            } else {
                result.bounds.push_back(expression(child));
            }
        });
        return result;
    }
    ast::Switch switch_(Node n) const {
        ast::Switch result;
        auto child = first(n);
        result.value = std::make_unique<ast::Expression>(expression(child));
        for (child = next(child); child < end(n); child = next(child)) {
            ast::Switch::Arm arm;
            each_child(child, [&](Node part) {
                if (kind(part) == Kind::items) {
                    arm.items = items(part);
                } else {
                    arm.values.push_back(expression(part));
                }
            });
            result.arms.push_back(std::move(arm));
        }
        return result;
    }
    ast::Macro macro(Node n) const {
        ast::Macro result;
        each_child(n, [&](Node child) {
            if (kind(child) == Kind::name) result.name = word(child);
            if (kind(child) == Kind::parameter) result.parameters.push_back(word(child));
            if (kind(child) == Kind::macro_body) result.body = span(child);
        });
        return result;
    }

    Span text_;
    std::vector<SyntaxNode> nodes_;
    mutable int split_depth_ = 0;
};

}  // namespace

ast::Program parse(const Span& part) { return TreeReader(part, parse_syntax(part)).program(); }

ast::Program parse(const Source& source) {
    return parse(Span{&source, 0, static_cast<std::uint32_t>(source.text().size())});
}

}  // namespace meniscus::lang
