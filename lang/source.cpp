#include "lang/source.hpp"

#include <algorithm>
#include <utility>

namespace meniscus::lang {

Source::Source(std::string name, std::string text, std::filesystem::path folder)
    : name_(std::move(name)), text_(std::move(text)), folder_(std::move(folder)) {
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (text_[i] == '\n') line_starts_.push_back(i + 1);
    }
}

std::size_t Source::line_index(std::size_t offset) const {
    const auto next = std::ranges::upper_bound(line_starts_, offset);
    return static_cast<std::size_t>(next - line_starts_.begin()) - 1;
}

scene::Location Source::location(std::size_t offset) const {
    const auto line = line_index(offset);
    return {name_, static_cast<int>(line) + 1, static_cast<int>(offset - line_starts_[line]) + 1};
}

std::string_view Source::line_at(std::size_t offset) const {
    const auto line = line_index(offset);
    const auto begin = line_starts_[line];
    auto end = line + 1 < line_starts_.size() ? line_starts_[line + 1] - 1 : text_.size();
    if (end > begin && text_[end - 1] == '\r') --end;
    return std::string_view{text_}.substr(begin, end - begin);
}

}  // namespace meniscus::lang
