#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meniscus::compare {

/// Text as it may stand in HTML and SVG, between tags and in attributes.
std::string escape(std::string_view text);

std::string base64(std::string_view bytes);
/// For src and href: the bytes themselves.
std::string data_uri(std::string_view media_type, std::string_view bytes);

/// An HTML table; cells are markup, as escape() makes it. The first cell of each row is its head;
/// the last of one that is shorter than the table's head goes over all that are left.
struct Table {
    std::string caption;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};
std::string format_table(const Table& table);

}  // namespace meniscus::compare
