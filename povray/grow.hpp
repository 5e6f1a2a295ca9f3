#pragma once

#include "geom/lathe.hpp"
#include "geom/triangle_mesh.hpp"
#include "scene/object.hpp"

namespace meniscus::povray {

/// The closed object with its surface moved outwards by `distance` (scene units; inwards if
/// negative): exactly so for spheres, boxes, planes, cylinders, cones and tori under similarities,
/// boxes and planes under any map; a stretched sphere by the distance along each axis; lathes and
/// meshes as below; other stretched shapes by the distance where they are least stretched.
/// Throws ExportError at the object's line where nothing sound comes out.
scene::Object grown(const scene::Object& object, double distance);

/// A profile whose control points are moved along their legs' normals, joined by mitres (Tiller and
/// Hanson 1984): exact for straight pieces; curved ones, cut in four before, move by up to some 1 %
/// less than the distance where they bend. Throws std::invalid_argument if the profile is too sharp
/// for it.
geom::Lathe offset(const geom::Lathe& lathe, double distance);

/// The mesh's triangles under a map, with the normals that they are shaded with.
geom::TriangleSoup soup_of(const geom::TriangleMesh& mesh, const geom::Transform& transform);

/// Vertices moved along their angle-weighted normals, far enough that no face moves less; they keep
/// the normals that they are shaded with. Throws std::invalid_argument where the result would meet
/// itself.
geom::TriangleSoup offset(const geom::TriangleMesh& mesh, double distance);

}  // namespace meniscus::povray
