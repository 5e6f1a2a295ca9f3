#pragma once

#include "geom/vec.hpp"

namespace meniscus::scene {

/// After all of `look_at`, `angle`, `sky` and transformations: the picture is the rectangle spanned
/// by right and up, each pixel (a, b) in [-1/2, 1/2]^2. Perspective rays leave `location` towards
/// direction + a right + b up; orthographic ones leave location + a right + b up along `direction`.
struct Camera {
    enum class Kind { perspective, orthographic };
    Kind kind = Kind::perspective;
    geom::Vec3 location{0.0};
    geom::Vec3 direction{0.0, 0.0, 1.0};
    geom::Vec3 right{1.33, 0.0, 0.0};
    geom::Vec3 up{0.0, 1.0, 0.0};
};

}  // namespace meniscus::scene
