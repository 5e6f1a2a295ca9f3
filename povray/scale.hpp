#pragma once

#include <string>
#include <vector>

#include "povray/export.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// What POV-Ray 3.7 sees, in its own units: shadow rays miss a hit nearer than `nearest`, others
/// one nearer than a tenth of it; no ray sees anything beyond `farthest`.
inline constexpr double nearest = 1e-3, farthest = 1e7;

/// The thinnest overlap of solids that all rays see, in POV-Ray's units, with a tenth to spare.
inline constexpr double least_overlap = 1.1 * nearest;

/// A power of ten by which the scene fits between the two: contact, whose overlap is to be small,
/// in some 10^4 units; films, plain scenes and scenes with a medium without end in some 10^3; films
/// twice as thick as `nearest`.
double natural_scale(const tracer::RenderScene& scene, const ExportOptions& options);

/// Where a scale does not fit the scene, what that does to the picture and which scale would.
std::vector<std::string> scale_warnings(const tracer::RenderScene& scene,
                                        const ExportOptions& options, double scale);

}  // namespace meniscus::povray
