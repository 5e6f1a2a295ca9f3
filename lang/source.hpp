#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/location.hpp"

namespace meniscus::lang {

/// The text of one file. Everything read from it points back into it, so it must outlive the
/// interpretation.
class Source {
public:
    Source(std::string name, std::string text, std::filesystem::path folder = {});
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    const std::string& name() const { return name_; }
    const std::string& text() const { return text_; }
    const std::filesystem::path& folder() const { return folder_; }

    scene::Location location(std::size_t offset) const;
    /// The line that holds the offset, without its end.
    std::string_view line_at(std::size_t offset) const;

private:
    std::size_t line_index(std::size_t offset) const;

    std::string name_, text_;
    std::filesystem::path folder_;
    std::vector<std::size_t> line_starts_;
};

/// The bytes [begin, end) of a source.
struct Span {
    const Source* source = nullptr;
    std::uint32_t begin = 0, end = 0;

    scene::Location location() const {
        return source ? source->location(begin) : scene::Location{};
    }
    std::string_view text() const {
        return source ? std::string_view{source->text()}.substr(begin, end - begin) : "";
    }
};

}  // namespace meniscus::lang
