#pragma once

#include "scene/light.hpp"

namespace meniscus::tracer {

/// A light as a point sees it, shadows apart.
struct LightAt {
    geom::Vec3 direction;  // unit, towards the light
    double distance;       // how far a shadow ray has to go
    scene::Rgb color;      // after the beam's shape and fading; all 0 outside the beam
};

/// POV-Ray's lights: spot, cylinder and parallel beams, and fading by distance.
LightAt light_at(const scene::Light& light, const geom::Vec3& point);

}  // namespace meniscus::tracer
