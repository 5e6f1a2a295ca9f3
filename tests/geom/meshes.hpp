#pragma once

#include "geom/triangle_mesh.hpp"

namespace meniscus::geom {

/// A sphere of 20 * 4^levels triangles.
TriangleSoup icosphere(int levels, double radius = 1.0, const Vec3& center = Vec3{0.0});
/// A box whose sides are n x n squares of two triangles.
TriangleSoup gridded_box(int n, const Vec3& low, const Vec3& high);
/// A ring about the y axis of around x across quadrilaterals.
TriangleSoup torus_mesh(int around, int across, double major = 0.75, double minor = 0.25);
TriangleSoup joined(TriangleSoup a, const TriangleSoup& b);
TriangleSoup turned_inside_out(TriangleSoup soup);

}  // namespace meniscus::geom
