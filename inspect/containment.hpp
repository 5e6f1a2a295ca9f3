#pragma once

#include "tracer/render_scene.hpp"

namespace meniscus::inspect {

/// What is known of one solid lying wholly inside another.
enum class Containment {
    no,
    sampled,  // on all sample lines
    certain   // by the shapes' own numbers; touching from inside counts
};

/// Certain where the outer one is a sphere, box, cylinder or half-space, and the inner one made of
/// points and circles (all shapes but curved lathes); sampled otherwise.
Containment contained(const tracer::Part& inner, const tracer::Part& outer);

}  // namespace meniscus::inspect
