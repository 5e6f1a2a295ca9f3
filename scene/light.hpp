#pragma once

#include "geom/vec.hpp"
#include "scene/color.hpp"
#include "scene/location.hpp"

namespace meniscus::scene {

/// POV-Ray's light_source: a point, its colour, and what shapes its beam.
struct Light {
    enum class Kind { point, spot, cylinder };
    Kind kind = Kind::point;
    geom::Vec3 position{0.0};
    Rgb color{1.0};
    geom::Vec3 point_at{0.0, 0.0, 1.0};
    double radius = 30.0;  // spot: degrees from the axis, full light within; cylinder: scene units
                           // (default 0.75)
    double falloff =
        45.0;  // spot: degrees from the axis, dark beyond; cylinder: scene units (default 1)
    double tightness = 0.0;
    bool parallel = false;
    bool shadowless = false;
    double fade_distance = 0.0, fade_power = 0.0;  // both must be set to fade
    Location location;
};

}  // namespace meniscus::scene
