#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "lang/mesh_file.hpp"

namespace meniscus::lang {

using geom::TriangleIndices;
using geom::TriangleSoup;
using geom::Vec3;

namespace {

std::vector<Vec3> as_points(const std::vector<double>& numbers) {
    std::vector<Vec3> points;
    points.reserve(numbers.size() / 3);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
        points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    }
    return points;
}

/// What the OBJ library takes without a word: "nan" and what is missing as 0, large indices as
/// others.
void refuse_nonsense(const std::filesystem::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        line.resize(std::min(line.find('#'), line.size()));
        if (line.starts_with("v ") && line.find_first_of("nN") != std::string::npos) {
            fail_to_load(path, "a vertex of it is not finite: " + line);
        }
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v" && !(words >> word && words >> word && words >> word))
            fail_to_load(path, "a vertex of it has fewer than three coordinates: " + line);
        if (word != "f") continue;
        while (words >> word) {
            if (word.substr(0, word.find('/')).size() > 10)
                fail_to_load(path, "a face of it uses a vertex of an impossible number: " + line);
        }
    }
}

}  // namespace

TriangleSoup load_obj(const std::filesystem::path& path) {
    refuse_nonsense(path);
    std::ifstream file(path);
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &file)) {
        fail_to_load(path, error.empty() ? "it is no valid OBJ file" : first_line(error));
    }
    TriangleSoup soup;
    soup.positions = as_points(attributes.vertices);
    soup.normals = as_points(attributes.normals);
    for (const tinyobj::shape_t& shape : shapes) {
        const auto& corners = shape.mesh.indices;
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            TriangleIndices triangle, normals;
            for (std::size_t k = 0; k < 3; ++k) {
                const int index = corners[i + k].vertex_index;
                if (index < 0 || std::size_t(index) >= soup.positions.size())
                    fail_to_load(path, fmt::format("a face of it uses vertex {}, but it has {}",
                                                   index + 1, soup.positions.size()));
                triangle[k] = static_cast<std::uint32_t>(index);
                normals[k] = static_cast<std::uint32_t>(corners[i + k].normal_index);  // -1: none
            }
            soup.triangles.push_back(triangle);
            if (!soup.normals.empty()) soup.corner_normals.push_back(normals);
        }
    }
    return soup;
}

}  // namespace meniscus::lang
