#include "lang/load_mesh.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "lang/mesh_file.hpp"

namespace meniscus::lang {

void fail_to_load(const std::filesystem::path& path, const std::string& reason) {
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

std::shared_ptr<const geom::TriangleMesh> load_mesh(const std::filesystem::path& path,
                                                    bool is_numbered) {
    if (std::filesystem::is_directory(path)) fail_to_load(path, "it is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) fail_to_load(path, "there is no such file, or it may not be read");
    if (file.peek() == std::ifstream::traits_type::eof()) fail_to_load(path, "it is empty");

    const std::string extension = lower_extension(path);
    geom::TriangleSoup soup = extension == ".obj"   ? load_obj(path)
                              : extension == ".ply" ? load_ply(path)
                                                    : load_by_assimp(path);
    if (soup.triangles.empty()) fail_to_load(path, "it holds no triangles");
    soup.is_numbered = is_numbered;
    try {
        return std::make_shared<const geom::TriangleMesh>(std::move(soup));
    } catch (const std::invalid_argument& error) {
        fail_to_load(path, error.what());
    }
}

}  // namespace meniscus::lang
