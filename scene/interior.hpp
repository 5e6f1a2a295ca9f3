#pragma once

#include <optional>

#include "scene/color.hpp"

namespace meniscus::scene {

/// POV-Ray's `fade_distance`, `fade_power` and `fade_color`: how a medium dims light along the way
/// s in it. power >= 1000: exp(-(1 - color) s / distance); below: color + (1 - color) / (1 + (s /
/// distance)^power), per channel.
struct Fade {
    double distance = 0.0;  // 0: no fading
    double power = 0.0;     // 0: halves towards the color, once a segment and whatever its length
    Rgb color{0.0};
    bool operator==(const Fade&) const = default;
    bool is_active() const { return distance > 0.0; }
};

/// What fills a solid, and who wins where solids overlap.
struct Interior {
    double ior = 1.0;
    double priority = 0.0;  // larger wins
    Rgb absorption{0.0};    // Beer-Lambert, per scene unit: transmittance exp(-absorption * s)
    Fade fade;
    double caustics = 0.0;    // POV-Ray's fake: brightens shadow rays at each crossing
    bool states_ior = false;  // the scene says so (an opaque skin over it is a likely mistake)
    bool states_priority = false;

    bool attenuates() const { return absorption != Rgb{0.0} || fade.is_active(); }
    /// Alike: light passes from one to the other as if nothing were there.
    bool same_medium(const Interior& other) const {
        return ior == other.ior && absorption == other.absorption && fade == other.fade;
    }
};

}  // namespace meniscus::scene
