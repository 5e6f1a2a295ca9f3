#include "povray/write_mesh.hpp"

#include <array>
#include <map>
#include <vector>

namespace meniscus::povray {
namespace {

using geom::Vec3;

/// Each vector once, by number.
class Numbered {
public:
    std::size_t operator()(const Vec3& v) {
        const auto [found, is_new] =
            numbers_.try_emplace(std::array{v.x, v.y, v.z}, vectors_.size());
        if (is_new) vectors_.push_back(v);
        return found->second;
    }
    const std::vector<Vec3>& vectors() const { return vectors_; }

private:
    std::map<std::array<double, 3>, std::size_t> numbers_;
    std::vector<Vec3> vectors_;
};

using Indices = std::vector<std::array<std::size_t, 3>>;

void write_vectors(Writer& writer, std::string_view word, const std::vector<Vec3>& vectors,
                   bool are_places) {
    writer.open(word);
    writer.line("{},", vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        writer.line("{}{}", are_places ? place(vectors[i]) : vector(vectors[i]),
                    i + 1 < vectors.size() ? "," : "");
    }
    writer.close();
}

/// Turned round: POV-Ray takes the side that a left-handed turn looks at for the outer one, and
/// chooses the interior_texture by it.
void write_indices(Writer& writer, std::string_view word, const Indices& indices) {
    writer.open(word);
    writer.line("{},", indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto& [a, b, c] = indices[i];
        writer.line("<{}, {}, {}>{}", a, c, b, i + 1 < indices.size() ? "," : "");
    }
    writer.close();
}

}  // namespace

void write_triangles(Writer& writer, const geom::TriangleMesh& mesh) {
    Numbered places, normals;
    Indices corners, corner_normals;
    bool is_smooth = false;
    for (geom::Face face = 0; face < geom::Face(mesh.size()); ++face) {
        const auto triangle = mesh.corners(face);
        auto& corner = corners.emplace_back();
        auto& normal = corner_normals.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            corner[i] = places(triangle[i]);
            const Vec3 n = mesh.shading_normal(face, triangle[i]);
            normal[i] = normals(n);
            is_smooth = is_smooth || glm::length(n - mesh.normal(face)) > 1e-9;
        }
    }
    write_vectors(writer, "vertex_vectors", places.vectors(), true);
    if (is_smooth) write_vectors(writer, "normal_vectors", normals.vectors(), false);
    write_indices(writer, "face_indices", corners);
    if (is_smooth) write_indices(writer, "normal_indices", corner_normals);
    // Which way to look for the inside: along no likely edge.
    if (mesh.is_closed()) writer.line("inside_vector <0.0123, 1, 0.0317>");
}

}  // namespace meniscus::povray
