#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "lang/mesh_file.hpp"

namespace meniscus::lang {

using geom::TriangleIndices;
using geom::TriangleSoup;
using geom::Vec3;

namespace {

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

}  // namespace

TriangleSoup load_by_assimp(const std::filesystem::path& path) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene =
        importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_SortByPType |
                                             aiProcess_PreTransformVertices);
    if (scene == nullptr) fail_to_load(path, first_line(importer.GetErrorString()));

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

}  // namespace meniscus::lang
