#pragma once

#include "geom/ray.hpp"
#include "scene/camera.hpp"

namespace meniscus::tracer {

/// The ray through a point of the film, in pixels from the top left: (0.5, 0.5) is the first
/// pixel's centre. The whole right/up rectangle is stretched over the picture, whatever its shape.
inline geom::Ray camera_ray(const scene::Camera& camera, double x, double y, int width,
                            int height) {
    const double a = x / width - 0.5, b = 0.5 - y / height;
    const geom::Vec3 across = a * camera.right + b * camera.up;
    geom::Ray ray;
    if (camera.kind == scene::Camera::Kind::perspective) {
        ray.origin = camera.location;
        ray.direction = glm::normalize(camera.direction + across);
    } else {
        ray.origin = camera.location + across;
        ray.direction = glm::normalize(camera.direction);
    }
    return ray;
}

/// Where the ray through the middle of the picture starts.
inline geom::Vec3 camera_origin(const scene::Camera& camera) {
    return camera_ray(camera, 0.5, 0.5, 1, 1).origin;
}

}  // namespace meniscus::tracer
