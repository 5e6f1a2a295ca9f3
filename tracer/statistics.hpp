#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "geom/vec.hpp"

namespace meniscus::tracer {

/// Where a ray's list and its position disagreed by more than rounding.
struct Leak {
    std::size_t object;  // index into Scene::objects
    std::string kind;    // "not empty at infinity", "leaving without entry", "forced crossing",
                         // "wrong medium"
    geom::Vec3 position{0.0};
};

/// What one render did. All counts are exact and the same for any number of threads.
struct Statistics {
    std::uint64_t camera_rays = 0, reflected_rays = 0, refracted_rays = 0, shadow_rays = 0;
    std::uint64_t casts = 0;  // traversals of the scene
    std::uint64_t true_crossings = 0, false_crossings = 0;
    std::uint64_t segments = 0;     // from an origin to the next true crossing or to infinity
    std::uint64_t single_rays = 0;  // followed one at a time because lanes could not tell
    std::uint64_t leaks = 0;
    std::vector<Leak> first_leaks;  // at most max_first_leaks
    std::map<std::pair<std::size_t, std::string>, std::uint64_t>
        leaks_by_object;  // (object, kind): count
    std::uint64_t samples = 0;
    int deepest_level = 0;

    static constexpr std::size_t max_first_leaks = 10;
    void count_leak(const Leak& leak);
    void add(const Statistics& other);
};

}  // namespace meniscus::tracer
