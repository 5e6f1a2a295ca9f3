#pragma once

namespace meniscus::scene {

/// POV-Ray's assumed_gamma: how the numbers that a scene computes with stand for light. They are
/// light to the power of 1 / gamma, or on the sRGB curve.
struct WorkingSpace {
    double gamma = 1.0;    // 1: the numbers are light
    bool is_srgb = false;  // `assumed_gamma srgb`; gamma has no meaning then

    bool is_linear() const { return !is_srgb && gamma == 1.0; }
    /// What a number stands for; below 0, a power law gives 0.
    double to_light(double number) const;
    double from_light(double light) const;
    bool operator==(const WorkingSpace&) const = default;
};

/// The sRGB curve (IEC 61966-2-1), from its numbers to light: what `srgb` colours mean.
double light_of_srgb(double number);

}  // namespace meniscus::scene
