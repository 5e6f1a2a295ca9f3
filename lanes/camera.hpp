#pragma once

#include <cstddef>
#include <cstdint>

#include "lanes/ray_stack.hpp"

namespace meniscus::lanes {

/// Camera rays that share all but their directions: forward + (x / width - 0.5) right +
/// (0.5 - y / height) up, made unit length, through point (x, y) of the film.
struct Camera {
    WaitingRay start;
    geom::Vec3 forward{0.0}, right{0.0}, up{0.0};
    double width = 1.0, height = 1.0;
};

/// Points of the film that rays go through.
struct FilmPoints {
    static constexpr std::size_t most = 64;
    // Room for whole vectors.
    alignas(64) double x[most], y[most], weight[most];
    alignas(64) std::uint64_t pixel[most], key[most];
};

}  // namespace meniscus::lanes
