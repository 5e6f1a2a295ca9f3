#pragma once

#include <map>
#include <string>
#include <string_view>

namespace meniscus::compare {

/// An HTML page of one file: it needs no network and no other file. `body` is markup, `style` and
/// `script` go beside those that every page has.
struct Page {
    std::string title;
    std::string style, body, script;
};

std::string format_page(const Page& page);

/// The text with each {{name}} replaced; every name must have a value.
std::string fill(std::string_view text, const std::map<std::string, std::string>& values);

}  // namespace meniscus::compare
