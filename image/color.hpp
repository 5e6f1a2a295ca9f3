#pragma once

#include <cmath>

namespace meniscus::image {

/// IEC 61966-2-1: linear light in [0, 1] to the sRGB curve.
inline double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

inline double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// What stands in a PNG for a linear value.
enum class Encoding {
    srgb,    // the sRGB curve
    linear,  // the value itself, and the file says so (gAMA 1)
    raw      // the value itself, and the file says sRGB: for scenes whose numbers are meant for the
             // screen
};

/// The nearest of 0 ... max for a value clipped to [0, 1]; not a number counts as 0.
inline unsigned quantize(double value, Encoding encoding, unsigned max) {
    if (!(value > 0.0)) return 0;
    if (value >= 1.0) return max;
    return unsigned(
        std::floor((encoding == Encoding::srgb ? srgb_encode(value) : value) * max + 0.5));
}

}  // namespace meniscus::image
