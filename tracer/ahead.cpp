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

bool find_ahead(const geom::PlacedShape& shape, const geom::Ray& ray, const KnownStart& start,
                geom::Search search, geom::Crossings& out) {
    geom::Crossing own{0.0, geom::no_face, false};
    if (start.born_on != geom::no_face) {
        search.own = start.born_on;
        search.own_entering = start.starts_inside;
        search.own_met = &own;
    }
    if (!shape.crossings_ahead(ray, search, start.depth, out)) return false;
    if (search.own_met && !is_at_start(shape, ray, start, own)) return false;
    for (const geom::Crossing& crossing : out) {
        if (crossing.t > 1e-3 * start.magnitude) break;
        if (is_at_start(shape, ray, start, crossing)) return false;
    }
    return true;
}

}  // namespace meniscus::tracer
