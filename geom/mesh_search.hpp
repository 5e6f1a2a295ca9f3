#pragma once

#include <span>

#include "geom/bounds.hpp"
#include "geom/bvh_line.hpp"
#include "geom/bvh_node.hpp"
#include "geom/crossing.hpp"
#include "geom/ray.hpp"
#include "geom/triangle_blocks.hpp"

namespace meniscus::geom {

/// Which of a line's crossings a ray needs: those with from < t <= to, and none farther than a
/// little behind the nearest one that matters to it.
struct Search {
    double from = -infinity, to = infinity;
    bool entering_ends = false, leaving_ends = false;  // such a crossing at t...
    double slack = 0.0, slack_per_t = 0.0;  // ...draws `to` in to t + slack + slack_per_t * t
    double ends_from = -infinity;           // but not if it is nearer than this,
    Face own = no_face;                     // nor if it is of the face that the ray was born on:
    bool own_entering = false;              // how that is crossed, if the ray has not turned
    Crossing* own_met = nullptr;            // how it is: said here, not among the crossings
};

/// The triangles of a mesh under a hierarchy whose leaves are the blocks.
struct MeshView {
    const BvhNode* nodes;
    const BvhFrame& frame;
    const TriangleBlocks& blocks;
};

/// Appends the crossings wanted, in no particular order, and returns `to` as it was drawn in.
///
/// Eight boxes and four triangles are tested at once, in as many lanes as the processor has. Lanes
/// only find out which triangles may be hit; TriangleLine decides, so that the crossings do not
/// depend on the processor by a bit.
double find_crossings(const MeshView& mesh, const Ray& ray, const Search& search, Crossings& out);

/// One of several rays that are searched for together.
struct SearchedRay {
    Ray ray;
    Search search;
    Crossings found;  // is added to
    double end;       // `search.to` as it was drawn in
};

/// The same for each of the rays. They take turns, a node or a leaf each, so that one need not wait
/// for what another has asked memory for; the crossings are those that each would find alone.
void find_crossings(const MeshView& mesh, std::span<SearchedRay> rays);

}  // namespace meniscus::geom
