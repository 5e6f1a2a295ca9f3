#pragma once

#include <vector>

#include "tracer/film.hpp"

namespace meniscus::tracer {

/// The pixels that POV-Ray's anti-aliasing supersamples, by Film::index: those that differ from
/// their left or upper neighbour by `threshold` or more, summed over the gamma-encoded channels,
/// and those neighbours.
std::vector<bool> contrasting_pixels(const Film& film, double threshold);

}  // namespace meniscus::tracer
