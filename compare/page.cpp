#include "compare/page.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "compare/markup.hpp"
#include "compare/page_files.hpp"

namespace meniscus::compare {

std::string fill(std::string_view text, const std::map<std::string, std::string>& values) {
    std::string out;
    while (true) {
        const auto open = text.find("{{");
        out += text.substr(0, open);
        if (open == text.npos) return out;
        const auto close = text.find("}}", open);
        const std::string name(text.substr(open + 2, close - open - 2));
        const auto value = values.find(name);
        if (close == text.npos || value == values.end())
            throw std::logic_error(fmt::format("a page has no value for {{{{{}}}}}", name));
        out += value->second;
        text.remove_prefix(close + 2);
    }
}

std::string format_page(const Page& page) {
    return fill(page_files::page_html, {{"title", escape(page.title)},
                                        {"style", std::string(page_files::page_css) + page.style},
                                        {"body", page.body},
                                        {"script", page.script}});
}

}  // namespace meniscus::compare
