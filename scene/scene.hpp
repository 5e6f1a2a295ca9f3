#pragma once

#include <vector>

#include "scene/camera.hpp"
#include "scene/light.hpp"
#include "scene/object.hpp"
#include "scene/settings.hpp"
#include "scene/texture.hpp"

namespace meniscus::scene {

/// One layer of the sky: a pigment evaluated on the unit direction. Later layers lie over earlier
/// ones.
struct SkySphere {
    std::vector<Pigment> pigments;
    double emission = 1.0;
};

/// All that a scene file says, as plain values: what `lang` makes and `tracer` compiles.
struct Scene {
    Camera camera;
    Settings settings;
    std::vector<Solid> solids;
    std::vector<Texture> textures;
    std::vector<Object> objects;
    std::vector<Light> lights;
    Color background;  // default black
    SkySphere sky_sphere;
};

}  // namespace meniscus::scene
