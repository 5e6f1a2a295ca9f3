#include "lang/literals.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace meniscus::lang {
namespace {

void append_utf8(std::string& out, unsigned code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xC0 | (code >> 6));
        out += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        out += static_cast<char>(0xE0 | (code >> 12));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (code & 0x3F));
    }
}

}  // namespace

double parse_number(std::string_view text) {
    double value = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec == std::errc::result_out_of_range) {
        const auto e = text.find_first_of("eE");
        const bool tiny = e != std::string_view::npos && e + 1 < text.size() && text[e + 1] == '-';
        return tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return value;
}

ast::Text parse_string(std::string_view text) {
    ast::Text result;
    std::size_t i = 1;
    for (; i < text.size() && text[i] != '"'; ++i) {
        if (text[i] != '\\' || i + 1 >= text.size()) {
            result.value += text[i];
            continue;
        }
        switch (text[++i]) {
            case 'n':
                result.value += '\n';
                break;
            case 't':
                result.value += '\t';
                break;
            case 'r':
                result.value += '\r';
                break;
            case 'a':
                result.value += '\a';
                break;
            case 'b':
                result.value += '\b';
                break;
            case 'f':
                result.value += '\f';
                break;
            case 'v':
                result.value += '\v';
                break;
            case '0':
                break;
            case 'u': {
                unsigned code = 0;
                const auto* begin = text.data() + i + 1;
                const auto* stop = std::min(begin + 4, text.data() + text.size());
                const auto read = std::from_chars(begin, stop, code, 16);
                append_utf8(result.value, code);
                i += static_cast<std::size_t>(read.ptr - begin);
                break;
            }
            default:
                result.value += text[i];
        }
    }
    result.raw = text.substr(1, i > 0 ? i - 1 : 0);
    return result;
}

}  // namespace meniscus::lang
