#pragma once

#include "geom/shape.hpp"
#include "tests/oracle/random_scene.hpp"
#include "tests/random/random.hpp"

namespace meniscus::oracle {

/// A shape with all sizes on the lattice of halves, its middle at `center`; those that turn about
/// an axis of their own, and meshes, have their middle at the origin instead.
struct RandomShape {
    geom::Shape shape;
    bool at_origin = false;
};
RandomShape random_shape(Random& random, const RandomSceneOptions& options,
                         const geom::Vec3& center);

/// A closed mesh of triangles, its corners in `positions`.
geom::Mesh mesh_of(std::vector<geom::Vec3> positions, std::vector<geom::TriangleIndices> triangles);
/// Twelve triangles.
geom::Mesh box_mesh(const geom::Vec3& low, const geom::Vec3& high);
/// Eight triangles with corners on the axes.
geom::Mesh octahedron(const geom::Vec3& half);
/// The octahedron of half axes `radius`, its triangles split in four `levels` times and its corners
/// moved onto the sphere.
geom::Mesh ball_mesh(double radius, int levels);

}  // namespace meniscus::oracle
