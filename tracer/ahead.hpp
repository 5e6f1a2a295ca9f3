#pragma once

#include <optional>

#include "geom/placed_shape.hpp"

namespace meniscus::tracer {

/// What a ray knows of one shape where it starts.
struct KnownStart {
    double magnitude = 0.0;              // M there
    double tolerance = 0.0;              // of places there, along the normal
    std::optional<int> depth;            // how deep it is inside of the shape
    geom::Face born_on = geom::no_face;  // a face of it
    bool starts_inside = false;          // if it was born there: on which side
};

/// Whether the crossing is within `tolerance` of the ray's origin, along the normal.
bool is_at_start(const geom::PlacedShape& shape, const geom::Ray& ray, const KnownStart& start,
                 const geom::Crossing& crossing);

/// The short way for a mesh: only what lies ahead, as far as the search goes. Its directions of
/// crossing are exact, so where the first of them fits the depth that the ray knows, the whole line
/// would count to that depth too. Where it does not, or where anything but the triangle that the
/// ray was born on lies at the origin, it returns false, and the whole line must tell.
bool find_ahead(const geom::PlacedShape& shape, const geom::Ray& ray, const KnownStart& start,
                geom::Search search, geom::Crossings& out);

/// Its halves, for whoever searches by himself. What a search must know of the start; `own` is
/// where it says how the line crosses the face that the ray was born on.
void begin_ahead(const KnownStart& start, geom::Search& search, geom::Crossing& own);
/// Whether nothing that was found lies at the origin but `own`, which does.
bool is_clear_ahead(const geom::PlacedShape& shape, const geom::Ray& ray, const KnownStart& start,
                    const geom::Crossing& own, const geom::Crossings& found);

}  // namespace meniscus::tracer
