#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "geom/ray.hpp"

/// What the micro-benchmarks shoot: always the same rays.
namespace meniscus::benchmarks {

inline constexpr std::size_t ray_count = 1024;

inline geom::Vec3 random_point(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> number(-size, size);
    const double x = number(random), y = number(random);
    return {x, y, number(random)};
}

/// From 4 away to points of a box of half-width `size` round the coordinate origin.
inline std::vector<geom::Ray> rays_from_outside(double size) {
    std::mt19937 random(1);
    std::vector<geom::Ray> rays(ray_count);
    for (auto& ray : rays) {
        ray.origin = 4.0 * glm::normalize(random_point(random, 1.0));
        ray.direction = glm::normalize(random_point(random, size) - ray.origin);
    }
    return rays;
}

/// From points of that box in all directions.
inline std::vector<geom::Ray> rays_from_inside(double size) {
    std::mt19937 random(2);
    std::vector<geom::Ray> rays(ray_count);
    for (auto& ray : rays) {
        ray.origin = random_point(random, size);
        ray.direction = glm::normalize(random_point(random, 1.0));
    }
    return rays;
}

}  // namespace meniscus::benchmarks
