#pragma once

#include <cstdint>
#include <string_view>

#include "geom/transform.hpp"
#include "scene/scene.hpp"

namespace meniscus::oracle {

/// What a ray can be aimed at: where surfaces end, touch or turn away, and where it runs in them.
enum class Aim {
    corner,       // of a box, of two stacked boxes
    box_edge,     // of one box, or shared by two
    mesh_vertex,  // of an octahedron and of a tessellated ball
    mesh_edge,    // their edges
    rim,          // of a cylinder, a cone, lathes
    tip,          // of a cone, and where a lathe meets its axis
    touching,     // where a ball touches a box, a cylinder, another ball
    silhouette,   // tangent to a ball, a cylinder, a cone, a torus, lathes
    centre,       // through the middle, along the axis
    in_face,      // within a face of a box, of two boxes, of a mesh, within the water's level
    along_edge,   // along an edge of a box or a mesh, a side of a cylinder or a cone
    last = along_edge
};
std::string_view name(Aim aim);

/// Solids of every closed shape that share faces, edges and points of tangency; all under one
/// rotation if wanted.
class AimedScene {
public:
    explicit AimedScene(const geom::Vec3& angles_degrees);

    /// The scene, seen by a ray that passes the target at the distance `beside`.
    const scene::Scene& aimed(Aim aim, double beside, std::uint64_t seed);

private:
    scene::Scene scene_;
    geom::Transform rotation_;
};

/// How many kinds there are.
inline constexpr int aims = int(Aim::last) + 1;

/// One camera ray's tree, followed by the tracer.
struct AimedRay {
    std::uint64_t segments = 0, leaks = 0;
    double difference = 0.0;  // from the oracle's light, of the largest channel
    // Of those that differ by more than 1e-6: whether it is the light where nothing but what
    // coincides is in contact; and whether it lies between the lights, of both kinds, of rays
    // within 1e-12 of this one, or of trees whose rays each start within 1e-14 of their place.
    bool is_one_of_two = true, is_explained = true;
};
AimedRay follow(const scene::Scene& scene);
/// The same, and by the oracle.
AimedRay compared(const scene::Scene& scene);

}  // namespace meniscus::oracle
