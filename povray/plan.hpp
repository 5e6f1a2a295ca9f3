#pragma once

#include <set>
#include <string>
#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::povray {

/// One dielectric solid of the scene and how it stands to the others.
struct Body {
    int solid;                // index into the scene's solids
    std::string name;         // a POV-Ray identifier, unlike all others
    std::vector<int> parts;   // of the compiled scene
    int rank = 0;             // 0 for the highest; unlike for neighbours
    bool is_outside = false;  // its medium is the outside's: it only takes away from others
    bool meets_opaque = false;
    std::vector<int> touched;        // closed opaque parts that it has a face in common with
    std::vector<int> higher, lower;  // bodies that overlap or touch it
};

/// What a model needs to know of a scene: who is where, and above whom.
struct Plan {
    std::vector<Body> bodies;
    std::vector<int> plain_parts;  // parts that are no dielectric
    std::set<int> filmed;          // of these, what a body touches: they get films in gap models
};

/// Throws ExportError where solids of one priority and unlike media overlap without nesting: then
/// no geometry says what is there.
Plan make_plan(const tracer::RenderScene& scene);

/// Those and their parts alone, without regard to each other.
Plan make_plain_plan(const tracer::RenderScene& scene);

}  // namespace meniscus::povray
