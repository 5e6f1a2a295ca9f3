#include "tracer/ahead.hpp"

#include <cmath>

namespace meniscus::tracer {

bool is_at_start(const geom::PlacedShape& shape, const geom::Ray& ray, const KnownStart& start,
                 const geom::Crossing& crossing) {
    const double distance = std::abs(crossing.t);
    if (distance <= start.tolerance) return true;
    if (distance > 1e-3 * start.magnitude) return false;
    const geom::Vec3 normal = shape.normal(crossing.face, ray.at(crossing.t));
    return distance * std::abs(glm::dot(ray.direction, normal)) <= start.tolerance;
}

void begin_ahead(const KnownStart& start, geom::Search& search, geom::Crossing& own) {
    // As near to the origin as crossings may be in the wrong order with it.
    search.from = -4096.0 * geom::unit_roundoff * start.magnitude;
    own.face = geom::no_face;
    if (start.born_on == geom::no_face) return;
    search.own = start.born_on;
    search.own_entering = start.starts_inside;
    search.own_met = &own;
}

bool is_clear_ahead(const geom::PlacedShape& shape, const geom::Ray& ray, const KnownStart& start,
                    const geom::Crossing& own, const geom::Crossings& found) {
    if (start.born_on != geom::no_face && !is_at_start(shape, ray, start, own)) return false;
    for (const geom::Crossing& crossing : found) {
        if (crossing.t > 1e-3 * start.magnitude) break;
        if (is_at_start(shape, ray, start, crossing)) return false;
    }
    return true;
}

bool find_ahead(const geom::PlacedShape& shape, const geom::Ray& ray, const KnownStart& start,
                geom::Search search, geom::Crossings& out) {
    geom::Crossing own;
    begin_ahead(start, search, own);
    return shape.crossings_ahead(ray, search, start.depth, out) &&
           is_clear_ahead(shape, ray, start, own, out);
}

}  // namespace meniscus::tracer
