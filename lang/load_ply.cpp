#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/mesh_file.hpp"

namespace meniscus::lang {

using geom::TriangleSoup;
using geom::Vec3;

namespace {

/// Stanford's .ply, as text or binary of either byte order; numbers keep all of their digits.
/// (Assimp reads it in single precision, and does not survive files that are cut short.)
class PlyReader {
public:
    PlyReader(const std::filesystem::path& path, std::string data)
        : path_(path), data_(std::move(data)) {}

    TriangleSoup read() {
        read_header();
        TriangleSoup soup;
        for (const Element& element : elements_) {
            for (std::size_t i = 0; i < element.count; ++i) read_item(element, soup);
        }
        if (soup.normals.size() != soup.positions.size()) soup.normals.clear();
        // A vertex has its normal under the same number.
        if (!soup.normals.empty()) soup.corner_normals = soup.triangles;
        return soup;
    }

private:
    struct Type {
        char kind;  // i, u or f
        int size;
    };
    struct Property {
        std::string name;
        Type type;
        std::optional<Type> list_count;
    };
    struct Element {
        std::string name;
        std::size_t count;
        std::vector<Property> properties;
    };

    void read_header() {
        if (header_line() != "ply") fail_to_load(path_, "it does not begin as a PLY file does");
        while (true) {
            std::istringstream line(header_line());
            std::string word, name, type;
            line >> word;
            if (word == "end_header") return require_coordinates();
            if (word == "format") {
                line >> name;
                text_ = name == "ascii";
                swapped_ = name == "binary_big_endian";
                if (!text_ && !swapped_ && name != "binary_little_endian") {
                    fail_to_load(path_, "its format '" + name + "' is none of PLY's");
                }
            } else if (word == "element") {
                std::size_t count = 0;
                line >> name >> count;
                if (!line || count > data_.size()) fail_to_load(path_, "it is cut short");
                elements_.push_back({name, count, {}});
            } else if (word == "property" && !elements_.empty()) {
                std::optional<Type> list_count;
                line >> type;
                if (type == "list") {
                    line >> type;
                    list_count = type_named(type);
                    line >> type;
                }
                line >> name;
                elements_.back().properties.push_back({name, type_named(type), list_count});
            } else if (word != "comment" && word != "obj_info") {
                fail_to_load(path_, "its header has a line that begins with '" + word + "'");
            }
        }
    }

    void require_coordinates() const {
        for (const Element& element : elements_) {
            if (element.name != "vertex") continue;
            for (const std::string axis : {"x", "y", "z"}) {
                if (std::ranges::find(element.properties, axis, &Property::name) ==
                    element.properties.end())
                    fail_to_load(path_, "its vertices have no " + axis);
            }
        }
    }

    std::string header_line() {
        const std::size_t end = data_.find('\n', at_);
        if (end == std::string::npos) fail_to_load(path_, "its header has no end");
        std::string line = data_.substr(at_, end - at_);
        if (!line.empty() && line.back() == '\r') line.pop_back();
        at_ = end + 1;
        return line;
    }

    Type type_named(const std::string& name) const {
        static const std::map<std::string, Type> types{
            {"char", {'i', 1}},   {"int8", {'i', 1}},    {"uchar", {'u', 1}},
            {"uint8", {'u', 1}},  {"short", {'i', 2}},   {"int16", {'i', 2}},
            {"ushort", {'u', 2}}, {"uint16", {'u', 2}},  {"int", {'i', 4}},
            {"int32", {'i', 4}},  {"uint", {'u', 4}},    {"uint32", {'u', 4}},
            {"float", {'f', 4}},  {"float32", {'f', 4}}, {"double", {'f', 8}},
            {"float64", {'f', 8}}};
        const auto found = types.find(name);
        if (found == types.end())
            fail_to_load(path_, "its header has an unknown type '" + name + "'");
        return found->second;
    }

    double number(Type type) {
        if (text_) {
            const char* end = data_.data() + data_.size();
            while (at_ < data_.size() && std::isspace(static_cast<unsigned char>(data_[at_])))
                ++at_;
            double value = 0.0;
            const auto result = std::from_chars(data_.data() + at_, end, value);
            if (result.ec != std::errc{}) {
                fail_to_load(path_, at_ == data_.size() ? "it is cut short"
                                                        : "it has a word where a number belongs");
            }
            at_ = static_cast<std::size_t>(result.ptr - data_.data());
            return value;
        }
        std::array<unsigned char, 8> bytes{};
        const auto size = static_cast<std::size_t>(type.size);
        if (data_.size() - at_ < size) fail_to_load(path_, "it is cut short");
        for (std::size_t i = 0; i < size; ++i) {
            bytes[swapped_ ? size - 1 - i : i] = static_cast<unsigned char>(data_[at_ + i]);
        }
        at_ += size;
        std::uint64_t bits = 0;
        for (std::size_t i = size; i-- > 0;) bits = bits << 8 | bytes[i];
        if (type.kind == 'u') return static_cast<double>(bits);
        if (type.kind == 'f' && size == 8) return std::bit_cast<double>(bits);
        if (type.kind == 'f') return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        const int unused_bits = 64 - 8 * type.size;  // carries the sign up
        return static_cast<double>(static_cast<std::int64_t>(bits << unused_bits) >> unused_bits);
    }

    void read_item(const Element& element, TriangleSoup& soup) {
        const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
        Vec3 position{0.0}, normal{0.0};
        bool has_normal = false;
        for (const Property& property : element.properties) {
            if (property.list_count) {
                const double count = number(*property.list_count);
                if (!(count >= 0.0 && count <= static_cast<double>(data_.size()))) {
                    fail_to_load(path_, "it has a list of impossible length");
                }
                polygon_.clear();
                for (double i = 0.0; i < count; ++i) {
                    const double index = number(property.type);
                    if (!is_face) continue;
                    if (!(index >= 0.0 && index < 4294967295.0)) {
                        fail_to_load(path_, "a face of it uses a vertex of an impossible number");
                    }
                    polygon_.push_back(static_cast<std::uint32_t>(index));
                }
                if (is_face &&
                    (property.name == "vertex_indices" || property.name == "vertex_index")) {
                    faces_of(polygon_, soup);
                }
                continue;
            }
            const double value = number(property.type);
            const std::string_view axes = "xyz";
            if (property.name.size() == 1 && axes.find(property.name) != axes.npos) {
                position[static_cast<int>(axes.find(property.name))] = value;
            } else if (property.name.size() == 2 && property.name[0] == 'n' &&
                       axes.find(property.name[1]) != axes.npos) {
                normal[static_cast<int>(axes.find(property.name[1]))] = value;
                has_normal = true;
            }
        }
        if (is_vertex) soup.positions.push_back(position);
        if (is_vertex && has_normal) soup.normals.push_back(normal);
    }

    /// A fan of triangles from a corner that sees the whole polygon; most have one.
    static void faces_of(const std::vector<std::uint32_t>& polygon, TriangleSoup& soup) {
        const std::size_t n = polygon.size();
        const auto at = [&](std::size_t i) {
            const std::uint32_t index = polygon[i % n];
            return index < soup.positions.size() ? soup.positions[index] : Vec3{0.0};
        };
        Vec3 area{0.0};
        for (std::size_t i = 1; i + 1 < n; ++i)
            area += glm::cross(at(i) - at(0), at(i + 1) - at(0));
        const auto sees_all = [&](std::size_t hub) {
            for (std::size_t i = hub + 1; i + 1 < hub + n; ++i) {
                if (glm::dot(glm::cross(at(i) - at(hub), at(i + 1) - at(hub)), area) < 0.0)
                    return false;
            }
            return true;
        };
        std::size_t hub = 0;
        while (n > 3 && hub < n && !sees_all(hub)) ++hub;
        for (std::size_t i = hub + 1; i + 1 < hub + n; ++i) {
            soup.triangles.push_back({polygon[hub % n], polygon[i % n], polygon[(i + 1) % n]});
        }
    }

    std::filesystem::path path_;
    std::string data_;
    std::size_t at_ = 0;
    bool text_ = false, swapped_ = false;
    std::vector<Element> elements_;
    std::vector<std::uint32_t> polygon_;
};

}  // namespace

TriangleSoup load_ply(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return PlyReader(path, {std::istreambuf_iterator<char>(file), {}}).read();
}

}  // namespace meniscus::lang
