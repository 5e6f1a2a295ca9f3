#pragma once

#include "geom/vec.hpp"

namespace meniscus::scene {

/// Linear light: red, green, blue, in no particular unit; 1 is full scale in a picture.
using Rgb = geom::Vec3;

/// A pigment's colour: what it reflects, and how much light passes through it, tinted (`filter`)
/// and untinted (`transmit`).
struct Color {
    Rgb rgb{0.0};
    double filter = 0.0;
    double transmit = 0.0;

    /// The factor on light that passes through.
    Rgb transparency() const { return filter * rgb + Rgb{transmit}; }
    double opacity() const { return 1.0 - filter - transmit; }
    bool operator==(const Color&) const = default;
};

/// POV-Ray's grey: 0.297 r + 0.589 g + 0.114 b.
inline double gray(const Rgb& c) { return 0.297 * c.r + 0.589 * c.g + 0.114 * c.b; }

inline double max_channel(const Rgb& c) { return glm::max(c.r, glm::max(c.g, c.b)); }

}  // namespace meniscus::scene
