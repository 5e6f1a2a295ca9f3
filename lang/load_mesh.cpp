#include "lang/load_mesh.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <bit>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meniscus::lang {

namespace {

using geom::TriangleIndices;
using geom::TriangleSoup;
using geom::Vec3;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error("cannot load the mesh '" + path.string() + "': " + reason);
}

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::string first_line(std::string text) {
    text.resize(std::min(text.find_first_of("\r\n"), text.size()));
    return text;
}

std::vector<Vec3> as_points(const std::vector<double>& numbers) {
    std::vector<Vec3> points;
    points.reserve(numbers.size() / 3);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
        points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    }
    return points;
}

/// The OBJ library reads "nan" as 0.
void refuse_non_numbers(const std::filesystem::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        line.resize(std::min(line.find('#'), line.size()));
        if (line.starts_with("v ") && line.find_first_of("nN") != std::string::npos) {
            fail(path, "a vertex of it is not finite: " + line);
        }
    }
}

TriangleSoup load_obj(const std::filesystem::path& path) {
    refuse_non_numbers(path);
    std::ifstream file(path);
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &file)) {
        fail(path, error.empty() ? "it is no valid OBJ file" : first_line(error));
    }
    TriangleSoup soup;
    soup.positions = as_points(attributes.vertices);
    soup.normals = as_points(attributes.normals);
    for (const tinyobj::shape_t& shape : shapes) {
        const auto& corners = shape.mesh.indices;
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            TriangleIndices triangle, normals;
            for (std::size_t k = 0; k < 3; ++k) {
                triangle[k] = static_cast<std::uint32_t>(corners[i + k].vertex_index);
                normals[k] = static_cast<std::uint32_t>(corners[i + k].normal_index);  // -1: none
            }
            soup.triangles.push_back(triangle);
            if (!soup.normals.empty()) soup.corner_normals.push_back(normals);
        }
    }
    return soup;
}

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
        if (header_line() != "ply") fail(path_, "it does not begin as a PLY file does");
        while (true) {
            std::istringstream line(header_line());
            std::string word, name, type;
            line >> word;
            if (word == "end_header") return;
            if (word == "format") {
                line >> name;
                text_ = name == "ascii";
                swapped_ = name == "binary_big_endian";
                if (!text_ && !swapped_ && name != "binary_little_endian") {
                    fail(path_, "its format '" + name + "' is none of PLY's");
                }
            } else if (word == "element") {
                std::size_t count = 0;
                line >> name >> count;
                if (!line || count > data_.size()) fail(path_, "it is cut short");
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
                fail(path_, "its header has a line that begins with '" + word + "'");
            }
        }
    }

    std::string header_line() {
        const std::size_t end = data_.find('\n', at_);
        if (end == std::string::npos) fail(path_, "its header has no end");
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
        if (found == types.end()) fail(path_, "its header has an unknown type '" + name + "'");
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
                fail(path_, at_ == data_.size() ? "it is cut short"
                                                : "it has a word where a number belongs");
            }
            at_ = static_cast<std::size_t>(result.ptr - data_.data());
            return value;
        }
        std::array<unsigned char, 8> bytes{};
        const auto size = static_cast<std::size_t>(type.size);
        if (data_.size() - at_ < size) fail(path_, "it is cut short");
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
                    fail(path_, "it has a list of impossible length");
                }
                polygon_.clear();
                for (double i = 0.0; i < count; ++i) {
                    const double index = number(property.type);
                    if (!is_face) continue;
                    if (!(index >= 0.0 && index < 4294967295.0)) {
                        fail(path_, "a face of it uses a vertex of an impossible number");
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

TriangleSoup load_ply(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return PlyReader(path, {std::istreambuf_iterator<char>(file), {}}).read();
}

void append(TriangleSoup& soup, const aiMesh& mesh, bool with_normals) {
    const auto offset = static_cast<std::uint32_t>(soup.positions.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& p = mesh.mVertices[i];
        soup.positions.push_back({p.x, p.y, p.z});
        if (!with_normals) continue;
        const aiVector3D n = mesh.HasNormals() ? mesh.mNormals[i] : aiVector3D{};
        soup.normals.push_back({n.x, n.y, n.z});
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) continue;
        TriangleIndices triangle, normals;
        for (unsigned k = 0; k < 3; ++k) {
            triangle[k] = offset + face.mIndices[k];
            normals[k] = mesh.HasNormals() ? triangle[k] : TriangleSoup::no_normal;
        }
        soup.triangles.push_back(triangle);
        if (with_normals) soup.corner_normals.push_back(normals);
    }
}

TriangleSoup load_by_assimp(const std::filesystem::path& path) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene =
        importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_SortByPType |
                                             aiProcess_PreTransformVertices);
    if (scene == nullptr) fail(path, first_line(importer.GetErrorString()));

    // The normals of an STL file are those of its flat triangles.
    bool with_normals = false;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        with_normals |= scene->mMeshes[i]->HasNormals() && lower_extension(path) != ".stl";
    }
    TriangleSoup soup;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        append(soup, *scene->mMeshes[i], with_normals);
    }
    return soup;
}

}  // namespace

std::shared_ptr<const geom::TriangleMesh> load_mesh(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path)) fail(path, "it is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "there is no such file, or it may not be read");
    if (file.peek() == std::ifstream::traits_type::eof()) fail(path, "it is empty");

    const std::string extension = lower_extension(path);
    TriangleSoup soup = extension == ".obj"   ? load_obj(path)
                        : extension == ".ply" ? load_ply(path)
                                              : load_by_assimp(path);
    if (soup.triangles.empty()) fail(path, "it holds no triangles");
    try {
        return std::make_shared<const geom::TriangleMesh>(std::move(soup));
    } catch (const std::invalid_argument& error) {
        fail(path, error.what());
    }
}

}  // namespace meniscus::lang
