#include "cli/diagnostics.hpp"

#include <fmt/color.h>

#include <array>

#include "cli/progress.hpp"

namespace meniscus::cli {
namespace {

struct Mark {
    std::string_view text;
    fmt::text_style style;
};
const auto marks = std::to_array<Mark>({
    {" error: ", fmt::emphasis::bold | fg(fmt::terminal_color::red)},
    {" warning: ", fmt::emphasis::bold | fg(fmt::terminal_color::magenta)},
    {" note: ", fmt::emphasis::bold | fg(fmt::terminal_color::cyan)},
});
const auto caret_style = fmt::emphasis::bold | fg(fmt::terminal_color::green);

bool is_caret_line(std::string_view line) {
    return line.find('^') != line.npos && line.find_first_not_of(" \t^~") == line.npos;
}

void print_colored(std::string_view line) {
    if (is_caret_line(line)) return fmt::print(stderr, caret_style, "{}", line);
    for (const auto& mark : marks)
        if (const auto at = line.find(mark.text); at != line.npos) {
            fmt::print(stderr, "{}", line.substr(0, at));
            fmt::print(stderr, mark.style, "{}", mark.text);
            return fmt::print(stderr, "{}", line.substr(at + mark.text.size()));
        }
    fmt::print(stderr, "{}", line);
}

}  // namespace

void print_diagnostic(std::string_view formatted) {
    const bool colored = is_terminal(stderr);
    while (!formatted.empty()) {
        const auto line = formatted.substr(0, formatted.find('\n'));
        formatted.remove_prefix(std::min(line.size() + 1, formatted.size()));
        colored ? print_colored(line) : fmt::print(stderr, "{}", line);
        fmt::print(stderr, "\n");
    }
}

void print_error(std::string_view text) {
    print_diagnostic(fmt::format("meniscus: error: {}", text));
}

void print_warning(std::string_view text) {
    print_diagnostic(fmt::format("meniscus: warning: {}", text));
}

}  // namespace meniscus::cli
