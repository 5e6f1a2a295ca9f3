#include "lang/syntax_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tao/pegtl.hpp>

#include "grammar/messages.hpp"
#include "grammar/scene_grammar.hpp"
#include "lang/diagnostic.hpp"
#include "lang/stack.hpp"

namespace meniscus::lang {
namespace {

namespace g = grammar;
namespace peg = tao::pegtl;

constexpr int deepest_nesting = 500;

template <class Rule, class... Bases>
inline constexpr bool derives = (std::is_base_of_v<Bases, Rule> || ...);

template <class Rule>
constexpr Kind kind_of() {
    // clang-format off
    if (derives<Rule, g::file>) return Kind::file;
    if (derives<Rule, g::number>) return Kind::number;
    if (derives<Rule, g::string>) return Kind::string;
    if (derives<Rule, g::vector>) return Kind::vector;
    if (derives<Rule, g::call>) return Kind::call;
    if (derives<Rule, g::callee, g::function_of_one>) return Kind::callee;
    if (derives<Rule, g::argument, g::only_argument>) return Kind::argument;
    if (derives<Rule, g::constant>) return Kind::constant;
    if (derives<Rule, g::variable>) return Kind::variable_name;
    if (derives<Rule, g::element_of>) return Kind::element_of;
    if (derives<Rule, g::array_size>) return Kind::array_size;
    if (derives<Rule, g::index>) return Kind::index;
    if (derives<Rule, g::member_name>) return Kind::member_name;
    if (derives<Rule, g::postfix>) return Kind::postfix;
    if (derives<Rule, g::sign>) return Kind::sign;
    if (derives<Rule, g::unary>) return Kind::unary;
    if (derives<Rule, g::product>) return Kind::product;
    if (derives<Rule, g::sum>) return Kind::sum;
    if (derives<Rule, g::relation>) return Kind::relation;
    if (derives<Rule, g::boolean>) return Kind::boolean;
    if (derives<Rule, g::choice>) return Kind::choice;
    if (derives<Rule, g::product_operator, g::sum_operator, g::relation_operator, g::boolean_operator>) return Kind::operator_;
    if (derives<Rule, g::separator, g::vector_comma>) return Kind::separator;
    if (derives<Rule, g::word, g::color_word>) return Kind::word;
    if (derives<Rule, g::block>) return Kind::block;
    if (derives<Rule, g::block_word>) return Kind::block_word;
    if (derives<Rule, g::function>) return Kind::function;
    if (derives<Rule, g::map_entry>) return Kind::map_entry;
    if (derives<Rule, g::array>) return Kind::array;
    if (derives<Rule, g::array_init>) return Kind::array_init;
    if (derives<Rule, g::element>) return Kind::element;
    if (derives<Rule, g::items>) return Kind::items;
    if (derives<Rule, g::value>) return Kind::value;
    if (derives<Rule, g::declare>) return Kind::declare;
    if (derives<Rule, g::semicolon>) return Kind::semicolon;
    if (derives<Rule, g::target>) return Kind::target;
    if (derives<Rule, g::name, g::macro_name>) return Kind::name;
    if (derives<Rule, g::undef>) return Kind::undef;
    if (derives<Rule, g::include>) return Kind::include;
    if (derives<Rule, g::default_>) return Kind::default_;
    if (derives<Rule, g::version>) return Kind::version;
    if (derives<Rule, g::elseif>) return Kind::elseif;
    if (derives<Rule, g::else_>) return Kind::else_;
    if (derives<Rule, g::if_>) return Kind::if_;
    if (derives<Rule, g::split_block>) return Kind::split_block;
    if (derives<Rule, g::ifdef>) return Kind::ifdef;
    if (derives<Rule, g::while_>) return Kind::while_;
    if (derives<Rule, g::for_>) return Kind::for_;
    if (derives<Rule, g::switch_>) return Kind::switch_;
    if (derives<Rule, g::case_>) return Kind::case_;
    if (derives<Rule, g::range>) return Kind::range;
    if (derives<Rule, g::break_>) return Kind::break_;
    if (derives<Rule, g::macro>) return Kind::macro;
    if (derives<Rule, g::macro_body>) return Kind::macro_body;
    if (derives<Rule, g::parameter>) return Kind::parameter;
    if (derives<Rule, g::message>) return Kind::message;
    if (derives<Rule, g::message_word>) return Kind::message_word;
    if (derives<Rule, g::file_io>) return Kind::file_io;
    // clang-format on
    return Kind::none;
}

/// A level of an expression that holds one operand only says nothing and is left out.
constexpr bool is_transparent(Kind kind) {
    return kind == Kind::postfix || kind == Kind::unary || kind == Kind::product ||
           kind == Kind::sum || kind == Kind::relation || kind == Kind::boolean ||
           kind == Kind::choice || kind == Kind::callee;
}

constexpr bool needs_end(Kind kind) {
    return kind == Kind::vector || kind == Kind::call || kind == Kind::block ||
           kind == Kind::map_entry || kind == Kind::array_init || kind == Kind::default_ ||
           kind == Kind::if_ || kind == Kind::ifdef || kind == Kind::while_ || kind == Kind::for_ ||
           kind == Kind::switch_ || kind == Kind::macro || kind == Kind::string;
}

/// What can contain itself, and so could nest without end.
template <class Rule>
inline constexpr bool can_nest =
    derives<Rule, g::block_comment, g::parenthesis, g::vector, g::call, g::index, g::choice_values,
            g::raw_brace, g::array_init, g::block, g::map_entry, g::directive, g::raw_directive>;

/// Collects nodes while the parser tries rules: a rule that fails takes its nodes back.
class Builder {
public:
    explicit Builder(const char* text) : text_(text) {}

    std::size_t mark() const { return nodes_.size(); }
    void open(Kind kind, const char* at) { nodes_.push_back({kind, offset(at), 0, 0}); }
    void take_back(std::size_t mark) { nodes_.resize(mark); }
    void close(std::size_t mark, const char* at) {
        auto& node = nodes_[mark];
        const auto size = nodes_.size() - mark;
        if (is_transparent(node.kind) && size > 1 && nodes_[mark + 1].size == size - 1) {
            nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(mark));
            return;
        }
        auto end = offset(at);
        while (end > node.begin && static_cast<unsigned char>(text_[end - 1]) <= ' ') --end;
        node.end = end;
        node.size = static_cast<std::uint32_t>(size);
    }
    /// Where the innermost thing begins that needs a closing mark and has none yet.
    const SyntaxNode* unclosed() const {
        for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
            if (node->size == 0 && needs_end(node->kind)) return &*node;
        }
        return nullptr;
    }
    std::vector<SyntaxNode> take() { return std::move(nodes_); }
    int depth = 0;

private:
    std::uint32_t offset(const char* at) const { return static_cast<std::uint32_t>(at - text_); }

    const char* text_;
    std::vector<SyntaxNode> nodes_;
};

class DepthGuard {
public:
    explicit DepthGuard(int& depth) : depth_(depth) { ++depth_; }
    ~DepthGuard() { --depth_; }
    DepthGuard(const DepthGuard&) = delete;
    DepthGuard& operator=(const DepthGuard&) = delete;

private:
    int& depth_;
};

template <class Rule>
struct build_nodes : peg::normal<Rule> {
    template <peg::apply_mode A, peg::rewind_mode M, template <class...> class Action,
              template <class...> class Control, class Input>
    static bool match(Input& in, Builder& builder) {
        constexpr auto kind = kind_of<Rule>();
        if constexpr (can_nest<Rule>) {
            if (builder.depth >= deepest_nesting || stack_is_nearly_full()) {
                throw peg::parse_error(fmt::format("nested more than {} deep", deepest_nesting),
                                       in);
            }
            const DepthGuard guard(builder.depth);
            return match_and_build<kind, A, M, Action, Control>(in, builder);
        } else {
            return match_and_build<kind, A, M, Action, Control>(in, builder);
        }
    }

private:
    template <Kind kind, peg::apply_mode A, peg::rewind_mode M, template <class...> class Action,
              template <class...> class Control, class Input>
    static bool match_and_build(Input& in, Builder& builder) {
        const auto mark = builder.mark();
        if constexpr (kind != Kind::none) builder.open(kind, in.current());
        if (!peg::match<Rule, A, M, Action, Control>(in, builder)) {
            builder.take_back(mark);
            return false;
        }
        if constexpr (kind != Kind::none) builder.close(mark, in.current());
        return true;
    }
};

template <class Rule>
using control = peg::must_if<g::messages, build_nodes, false>::control<Rule>;

/// The word or character at a place, as messages name it.
std::string found_at(const Span& text, std::size_t offset) {
    const auto& all = text.source->text();
    if (offset >= text.end) return "the end of the file";
    auto end = offset + 1;
    if (g::is_word_char(all[offset])) {
        while (end < text.end && g::is_word_char(all[end])) ++end;
    } else if (all[offset] == '#') {
        while (end < text.end && (all[end] == ' ' || all[end] == '\t')) ++end;
        while (end < text.end && g::is_word_char(all[end])) ++end;
    }
    const auto c = static_cast<unsigned char>(all[offset]);
    if (c < ' ' || c >= 127) return fmt::format("the byte 0x{:02X}", c);
    return fmt::format("'{}'", all.substr(offset, end - offset));
}

/// Where the innermost comment begins that the text does not end.
std::size_t open_comment(const Span& text) {
    const std::string_view all(text.source->text().data(), text.end);
    std::vector<std::size_t> open;
    for (std::size_t i = text.begin; i < all.size(); ++i) {
        const auto two = all.substr(i, 2);
        if (two == "/*") {
            open.push_back(i++);
        } else if (two == "*/" && !open.empty()) {
            open.pop_back();
            ++i;
        } else if (two == "//" && open.empty()) {
            i = std::min(all.find('\n', i), all.size());
        } else if (all[i] == '"' && open.empty()) {
            for (++i; i < all.size() && all[i] != '"'; ++i) i += all[i] == '\\';
        }
    }
    return open.empty() ? text.begin : open.back();
}

[[noreturn]] void throw_syntax_error(const Span& text, std::size_t offset, std::string message,
                                     const SyntaxNode* unclosed) {
    const auto found = found_at(text, offset);
    Span span{text.source, static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(offset)};
    if (found.front() == '\'') span.end += static_cast<std::uint32_t>(found.size() - 2);
    if (message == g::expected<g::known_directive>) {
        message += " '#" + found.substr(1);
    } else if (message.starts_with("expected")) {
        message += ", found " + found;
        if (message.starts_with(g::expected<g::close_brace>) && found.starts_with("'#")) {
            message +=
                ": a block must close where it opens, on the same side of #if, #else and #end";
        }
        if (found.size() > 2 &&
            g::is_reserved(std::string_view{found}.substr(1, found.size() - 2)) &&
            (message.starts_with("expected a name"))) {
            message += ", which is a word of the language";
        }
    }
    SourceError error(span, message);
    const bool is_comment = message.starts_with(g::expected<g::comment_end>);
    if ((unclosed || is_comment) && message.starts_with("expected '")) {
        const auto at = text.source->location(is_comment ? open_comment(text) : unclosed->begin);
        error.add_note({Diagnostic::Severity::note,
                        {},
                        fmt::format("it opened at {}:{}:{}", at.file, at.line, at.column),
                        {},
                        0});
    }
    throw error;
}

}  // namespace

std::vector<SyntaxNode> parse_syntax(const Span& text) {
    const auto* all = text.source->text().data();
    peg::memory_input<peg::tracking_mode::lazy> in(all + text.begin, all + text.end,
                                                   text.source->name());
    Builder builder(all);
    try {
        peg::parse<g::file, peg::nothing, control>(in, builder);
    } catch (const peg::parse_error& error) {
        throw_syntax_error(text, text.begin + error.positions().front().byte,
                           std::string(error.message()), builder.unclosed());
    }
    return builder.take();
}

}  // namespace meniscus::lang
