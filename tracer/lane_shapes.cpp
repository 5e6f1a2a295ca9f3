// What the kernel for lanes asks its host about solids that it has no code for.

#include <algorithm>
#include <cmath>

#include "tracer/ahead.hpp"
#include "tracer/lane_host.hpp"

namespace meniscus::tracer {

using geom::Vec3;

geom::Interval LaneHost::interval(const lanes::Solid& solid, const geom::Ray& ray, geom::Face pin) {
    return scene_.parts[std::size_t(solid.part)].shape.interval(ray, pin);
}

int LaneHost::crossings(const lanes::Solid& solid, const geom::Ray& ray, lanes::Met* out) {
    const geom::PlacedShape& shape = scene_.parts[std::size_t(solid.part)].shape;
    crossings_.clear();
    shape.crossings(ray, crossings_);
    if (crossings_.size() > std::size_t(lanes::most_lathe_crossings)) return -1;
    int count = 0;
    for (const geom::Crossing& crossing : crossings_) {
        // Only about the origin is more than the sign needed.
        double slope = crossing.entering ? -1.0 : 1.0;
        if (std::abs(crossing.t) <= 1e-3 * solid.magnitude) {
            const double cosine =
                std::abs(glm::dot(ray.direction, shape.normal(crossing.face, ray.at(crossing.t))));
            slope *= std::max(cosine, 1e-300);
        }
        out[count++] = {crossing.t, crossing.face, slope};
    }
    return count;
}

void LaneHost::meet_mesh(const lanes::Solid& solid, std::span<const lanes::MeshRay> rays,
                         lanes::MeshMet* met) {
    const geom::PlacedShape& shape = scene_.parts[std::size_t(solid.part)].shape;
    for (const lanes::MeshRay& ray : rays) {
        crossings_.clear();
        const double magnitude = ray.birth_magnitude + solid.magnitude;
        KnownStart start{magnitude, tolerance(scene_, magnitude), std::nullopt, ray.born_on,
                         ray.is_inside};
        if (ray.knows_side) start.depth = ray.is_inside ? 1 : 0;
        const geom::Search search{.from = 0.0,
                                  .to = ray.farthest,
                                  .entering_ends = !ray.is_hidden,
                                  .leaving_ends = !ray.is_hidden,
                                  .slack = ray.slack,
                                  .slack_per_t = ray.slack_per_t};
        lanes::MeshMet& answer = *met++;
        answer.is_sure = find_ahead(shape, ray.ray, start, search, crossings_);
        answer.known = ray.farthest;
        answer.starts_inside =
            ray.knows_side ? ray.is_inside : !crossings_.empty() && !crossings_[0].entering;
        answer.count = 0;
        bool entering = !answer.starts_inside;
        for (const geom::Crossing& crossing : crossings_) {
            if (answer.count == lanes::most_mesh_crossings || crossing.entering != entering) {
                answer.known = std::min(answer.known, crossing.t);
                break;
            }
            if (answer.count == 0 && !ray.is_hidden) {
                const double end = crossing.t + (ray.slack + ray.slack_per_t * crossing.t);
                answer.known = std::min(answer.known, end);
            }
            answer.at[std::size_t(answer.count++)] = crossing;
            entering = !entering;
        }
    }
}

Vec3 LaneHost::put_on_face(const lanes::Solid& solid, geom::Face face, Vec3& point) {
    geom::Ray at{point};
    const Vec3 normal = scene_.parts[std::size_t(solid.part)].shape.put_on_face(face, at).flat;
    point = at.at(0.0);
    return normal;
}

}  // namespace meniscus::tracer
