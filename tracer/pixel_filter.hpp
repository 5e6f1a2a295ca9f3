#pragma once

#include <string_view>
#include <vector>

#include "geom/vec.hpp"

namespace meniscus::tracer {

/// What part of a picture a pixel is the mean of, by distance from its centre, in pixels.
enum class PixelFilter {
    box,              // its own square: POV-Ray's
    blackman_harris,  // Harris 1978, four terms, radius 1.5: as Blender's default
    mitchell          // Mitchell and Netravali 1988, B = C = 1/3, radius 2; with negative lobes
};

std::string_view name(PixelFilter filter);

/// Draws points of a pixel's filter, instead of spreading samples over neighbouring pixels: so a
/// pixel depends on its own samples only (Ernst et al. 2006; Pharr et al. 2023, section 8.8).
class FilterSampler {
public:
    explicit FilterSampler(PixelFilter filter);

    struct Point {
        geom::Vec2 at;  // in pixels from the pixel's corner; (0.5, 0.5) is its centre
        double weight;  // negative in a negative lobe; its mean is 1
    };
    /// `uniform` in [0, 1)^2.
    Point point(const geom::Vec2& uniform) const;

private:
    struct Offset {
        double x, weight;
    };
    Offset offset(double uniform) const;

    PixelFilter filter_;
    double radius_ = 0.5;
    double integral_ = 1.0;           // of the filter along one axis
    std::vector<double> cumulative_;  // of its absolute value, at equal steps; the last one is 1
};

}  // namespace meniscus::tracer
