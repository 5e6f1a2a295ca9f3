#pragma once

#include <cstddef>
#include <string>

#include "geom/shape.hpp"
#include "geom/transform.hpp"
#include "scene/interior.hpp"
#include "scene/location.hpp"
#include "scene/texture.hpp"

namespace meniscus::scene {

/// One solid: what shares an interior. A union with an interior is one solid made of many objects;
/// it is counted, so that its members may overlap. An object without any such union is a solid of
/// its own.
struct Solid {
    std::string name;  // the declared name, else the shape's keyword; messages call it "glass
                       // (sphere)" or so
    Location location;
    Interior interior;
};

/// One shape in the scene, flattened out of its unions, with all transformations applied.
struct Object {
    geom::Shape shape;
    geom::Transform transform;  // shape's own frame to the world
    std::size_t solid = 0;      // index into Scene::solids
    std::size_t texture = 0;    // index into Scene::textures
    std::string name;
    Location location;
    bool inverse = false;  // the solid is what lies outside the shape
    bool no_shadow = false, no_image = false, no_reflection = false;
    bool double_illuminate = false;
    bool hollow = false;
};

}  // namespace meniscus::scene
