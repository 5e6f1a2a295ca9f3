#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geom/bvh.hpp"
#include "geom/placed_shape.hpp"
#include "scene/scene.hpp"
#include "tracer/neighbours.hpp"
#include "tracer/nesting.hpp"
#include "tracer/options.hpp"

namespace meniscus::tracer {

inline constexpr int outside = -1;
inline constexpr int no_anchor = -1;

/// A solid's share in the scene that rays meet: one placed shape.
struct Part {
    geom::PlacedShape shape;
    int object;  // index into the scene's objects
    int solid;   // index into the scene's solids; several parts of one union share it
    double priority;
    bool is_member;  // stands in interior lists; otherwise its surface is always met
    bool is_opaque;  // every ray ends on its surface
    bool inverse;
    bool no_shadow, no_image, no_reflection;
    bool double_illuminate;
    int anchor = no_anchor;  // index into the scene's anchors
};

/// What several parts share that lie far from the origin for their size, with thin films between
/// them: crossings of two such parts are compared by their distance from `point`, not from the
/// origin of coordinates (docs/numerics.md, "Far from the origin").
struct SharedAnchor {
    geom::Vec3 point;
    double size;      // how far from the point the largest of the parts reaches
    geom::Face face;  // of the parts, for which it holds; no_face: all
};

/// A scene made ready for rays; it never changes afterwards.
struct RenderScene {
    scene::Scene source;
    std::vector<Part> parts;
    geom::Bvh bvh;               // over the finite parts
    std::vector<int> bvh_parts;  // bvh primitive -> part
    // The same for spheres alone, close together in memory: most of many are missed, and that can
    // be told from so little. Of other shapes the radius is 0. Empty if there are few spheres.
    std::vector<geom::Sphere> bvh_spheres;
    std::vector<double> priorities;  // of the parts, close together
    Neighbours neighbours;
    Nesting nesting;             // over the finite parts, if they are deep in each other
    bool has_few_parts = false;  // finite ones: so few that it costs less to ask them all
    std::vector<SharedAnchor> anchors;
    std::vector<int> unbounded;      // half-spaces and complements: parts without finite bounds
    std::vector<int> selective;      // members that some kinds of rays do not see
    double size = 1.0;               // of the finite parts' bounds
    double tolerance_units = 16.0;   // the rounding bound of contact, in u M (docs/numerics.md)
    double contact_tolerance = 0.0;  // scene units along the normal, beside the rounding bound
    bool has_members = false;        // some solid can hold a ray
    bool has_attenuation = false;
    bool is_camera_clear = false;     // its rays start in one place, in no member and on none
    bool only_opaque_shades = false;  // all else lets light through as it is
    int lone_floor = outside;  // the part that alone casts shadows, if it is a half-space, which
                               // casts none on itself
    std::vector<std::string> skipped;  // what this scene does not need
};

/// Whether parts that no ray sees, inside of stronger ones, are in the scene: whoever looks at
/// lists wants them.
enum class Hidden { kept, left_out };
/// `recast` counts what it crosses, `off` has no priorities.
inline Hidden hidden_in(InteriorMode mode) {
    return mode == InteriorMode::sweep ? Hidden::left_out : Hidden::kept;
}

RenderScene compile(scene::Scene scene, Hidden hidden = Hidden::kept);

/// Finds the anchors that the scene asks for. `scene`'s parts and size are complete.
void find_anchors(RenderScene& scene);

}  // namespace meniscus::tracer
