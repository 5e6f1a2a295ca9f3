#pragma once

#include <span>
#include <vector>

#include "geom/triangle_mesh.hpp"

namespace meniscus::geom {

/// A ray as the tracer has it: it knows how deep it is inside, and the face that it was born on.
struct KnownRay {
    Ray ray;
    int depth = 0;
    Face born_on = no_face;
};

struct Nearest {
    double t = infinity;
    Face face = no_face;
};

/// Where a ray first meets the mesh.
Nearest nearest(const TriangleMesh& mesh, const KnownRay& known, Crossings& found);
/// The same of several rays, whose searches take turns.
class InTurns {
public:
    static constexpr std::size_t most = 16;
    void nearest(const TriangleMesh& mesh, std::span<const KnownRay> rays, Nearest* result);

private:
    std::array<SearchedRay, most> searched_;
    Crossings found_;
};

std::vector<KnownRay> primary_rays(int count);
/// From the surface inwards, in any direction.
std::vector<KnownRay> diffuse_rays(const TriangleMesh& mesh, int count);
/// All segments of paths that refract or reflect, by chance, at a glass of index 1.5.
std::vector<KnownRay> glass_chain(const TriangleMesh& mesh, int count);

}  // namespace meniscus::geom
