#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tracer/ray_state.hpp"

namespace meniscus::tracer {

/// What one light adds where nothing stands in its way.
struct LightTerm {
    scene::Rgb light;
    geom::Vec3 direction;  // unit, towards the light
    double distance;       // how far the shadow ray goes; 0: nothing can hide this light
    bool from_behind;      // the light is on the surface's far side
};

/// What a surface with a texture shows, by POV-Ray's rules of composition, and where rays go on.
struct Shading {
    std::vector<LightTerm> lights{};
    scene::Rgb own{0.0};     // without its lights
    geom::Vec3 normal{0.0};  // facing the ray

    scene::Rgb through{0.0};                  // share of the light from behind
    std::optional<geom::Vec3> transmitted{};  // its direction, if the ray tree follows it
    bool straight = false;                    // it goes on without bending
    bool total_reflection = false;            // takes the place of both

    scene::Rgb mirror{0.0};  // share of the reflected light
    double mirror_weight = 0.0;
    double mirror_exponent = 1.0;  // POV-Ray's `exponent`: not linear unless 1
};

/// `least_through` is POV-Ray's cut: no transmitted ray below this share (by gray value); without
/// it, none at 0. What `shading` held before is lost; it brings memory for its lights.
void shade(const RenderScene& scene, const geom::Vec3& direction, const Event& event,
           const geom::Vec3& shading_normal, std::optional<double> least_through, std::uint64_t key,
           Shading& shading);

/// Where a ray goes that a surface mirrors. A smooth normal may send it below the real surface: it
/// is reflected there once more, as POV-Ray does.
geom::Vec3 mirrored(const geom::Vec3& direction, const geom::Vec3& true_normal,
                    const geom::Vec3& shading_normal);

/// The ray from an event's point to a light, whose kind is not told yet.
TracedRay shadow_ray(const Event& event, const geom::Vec3& direction, bool from_behind);

}  // namespace meniscus::tracer
