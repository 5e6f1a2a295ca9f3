#include "lang/load_mesh.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

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

TriangleSoup load_obj(const std::filesystem::path& path) {
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

    TriangleSoup soup = lower_extension(path) == ".obj" ? load_obj(path) : load_by_assimp(path);
    if (soup.triangles.empty()) fail(path, "it holds no triangles");
    try {
        return std::make_shared<const geom::TriangleMesh>(std::move(soup));
    } catch (const std::invalid_argument& error) {
        fail(path, error.what());
    }
}

}  // namespace meniscus::lang
