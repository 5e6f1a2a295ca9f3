#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "geom/vec.hpp"

namespace meniscus::povray {

/// As many digits as bring back the same double.
std::string number(double value);
std::string vector(const geom::Vec3& v);
std::string vector(const geom::Vec2& v);
/// The same in the exported scene's units, which are S times as small.
std::string length(double value);
std::string place(const geom::Vec3& v);
std::string place(const geom::Vec2& v);

/// Text in lines and indented blocks.
class Writer {
public:
    template <class... Values>
    void line(fmt::format_string<Values...> format, Values&&... values) {
        add(fmt::format(format, std::forward<Values>(values)...));
    }
    /// "word {", and all up to `close` further in.
    void open(std::string_view word);
    void close();
    void blank() { text_ += '\n'; }
    const std::string& text() const { return text_; }

private:
    void add(std::string_view words);

    std::string text_;
    int depth_ = 0;
};

}  // namespace meniscus::povray
