#include "tracer/statistics.hpp"

#include <algorithm>

namespace meniscus::tracer {

void Statistics::add(const Statistics& other) {
    camera_rays += other.camera_rays;
    reflected_rays += other.reflected_rays;
    refracted_rays += other.refracted_rays;
    shadow_rays += other.shadow_rays;
    casts += other.casts;
    true_crossings += other.true_crossings;
    false_crossings += other.false_crossings;
    segments += other.segments;
    single_rays += other.single_rays;
    leaks += other.leaks;
    samples += other.samples;
    deepest_level = std::max(deepest_level, other.deepest_level);
    for (const Leak& leak : other.first_leaks) {
        if (first_leaks.size() < max_first_leaks) first_leaks.push_back(leak);
    }
    for (const auto& [key, count] : other.leaks_by_object) leaks_by_object[key] += count;
}

void Statistics::count_leak(const Leak& leak) {
    ++leaks;
    ++leaks_by_object[{leak.object, leak.kind}];
    if (first_leaks.size() < max_first_leaks) first_leaks.push_back(leak);
}

}  // namespace meniscus::tracer
