#pragma once

#include <memory>

#include "geom/primitive.hpp"
#include "geom/triangle_mesh.hpp"

namespace meniscus::geom {

/// mesh { ... }: triangles, shared between all objects that use them. A solid if the mesh is
/// closed, else a surface. A face is a triangle's index. The default is a cube.
struct Mesh {
    std::shared_ptr<const TriangleMesh> triangles = TriangleMesh::unit_cube();

    static constexpr auto keyword = "mesh";
    static constexpr auto fields = std::tuple<>{};
    static constexpr auto flags = std::tuple<>{};

    bool is_closed() const { return triangles->is_closed(); }
    Bounds bounds() const { return triangles->bounds(); }
    double magnitude() const { return triangles->magnitude(); }

    void crossings(const Ray& ray, Crossings& out) const { triangles->crossings(ray, out); }
    void crossings(const Ray& ray, const Search& search, Crossings& out) const {
        triangles->crossings(ray, search, out);
    }
    bool crossings_ahead(const Ray& ray, const Search& search, std::optional<int> depth,
                         Crossings& out) const {
        return triangles->crossings_ahead(ray, search, depth, out);
    }
    void hits(const Ray& ray, Crossings& out) const { triangles->crossings(ray, out); }
    bool contains(const Vec3& p) const { return triangles->depth_at(p) > 0; }
    int depth_at(const Vec3& p) const { return triangles->depth_at(p); }
    Vec3 normal(Face face, const Vec3&) const { return triangles->normal(face); }
    Vec3 shading_normal(Face face, const Vec3& p) const {
        return triangles->shading_normal(face, p);
    }
    Vec3 to_face(Face face, const Ray& point) const { return triangles->to_face(face, point); }
};

}  // namespace meniscus::geom
