#pragma once

#include <cmath>

#include "scene/interior.hpp"

namespace meniscus::tracer {

/// How much light is left after `distance` scene units in a medium: Beer-Lambert, and POV-Ray's
/// fade.
inline scene::Rgb transmittance(const scene::Interior& medium, double distance,
                                bool of_shadow = false) {
    scene::Rgb left{1.0};
    for (int i = 0; i < 3; ++i) {
        if (medium.absorption[i] != 0.0) left[i] = std::exp(-medium.absorption[i] * distance);
        const scene::Fade& fade = medium.fade;
        if (!fade.is_active() || (of_shadow && fade.power == 0.0)) continue;
        const double way = distance / fade.distance;
        if (fade.power >= 1000.0) {
            if (fade.color[i] != 1.0) left[i] *= std::exp(-(1.0 - fade.color[i]) * way);
        } else {
            left[i] *= fade.color[i] + (1.0 - fade.color[i]) / (1.0 + std::pow(way, fade.power));
        }
    }
    return left;
}

}  // namespace meniscus::tracer
