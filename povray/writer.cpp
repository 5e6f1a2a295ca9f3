#include "povray/writer.hpp"

namespace meniscus::povray {

std::string number(double value) { return fmt::format("{}", value == 0.0 ? 0.0 : value); }

std::string vector(const geom::Vec3& v) {
    return fmt::format("<{}, {}, {}>", number(v.x), number(v.y), number(v.z));
}

std::string vector(const geom::Vec2& v) {
    return fmt::format("<{}, {}>", number(v.x), number(v.y));
}

std::string length(double value) { return value == 0.0 ? "0" : number(value) + "*S"; }

std::string place(const geom::Vec3& v) {
    return v == geom::Vec3{0.0} ? vector(v) : vector(v) + "*S";
}

std::string place(const geom::Vec2& v) {
    return v == geom::Vec2{0.0} ? vector(v) : vector(v) + "*S";
}

void Writer::open(std::string_view word) {
    line("{} {{", word);
    ++depth_;
}

void Writer::close() {
    --depth_;
    add("}");
}

void Writer::add(std::string_view words) {
    text_.append(std::size_t(4 * depth_), ' ');
    text_ += words;
    text_ += '\n';
}

}  // namespace meniscus::povray
