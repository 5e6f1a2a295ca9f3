// What the kernel for lanes asks its host about solids that it has no code for.

#include <algorithm>
#include <cmath>

#include "tracer/ahead.hpp"
#include "tracer/lane_host.hpp"

namespace meniscus::tracer {

using geom::Vec3;

namespace {

/// What lanes are told of what a search has found.
lanes::MeshMet told(const lanes::MeshRay& ray, const geom::SearchedRay& searched) {
    lanes::MeshMet met;
    met.is_sure = true;
    met.known = searched.end;
    met.starts_inside =
        ray.knows_side ? ray.is_inside : !searched.found.empty() && !searched.found[0].entering;
    met.count = 0;
    bool entering = !met.starts_inside;
    for (const geom::Crossing& crossing : searched.found) {
        if (met.count == lanes::most_mesh_crossings || crossing.entering != entering) {
            met.known = std::min(met.known, crossing.t);
            break;
        }
        met.at[std::size_t(met.count++)] = crossing;
        entering = !entering;
    }
    return met;
}

}  // namespace

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
    const geom::TriangleMesh& mesh = *std::get<geom::Mesh>(shape.shape()).triangles;
    if (searched_.size() < rays.size()) {
        searched_.resize(rays.size());
        starts_.resize(rays.size());
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const lanes::MeshRay& ray = rays[i];
        const double magnitude = ray.birth_magnitude + solid.magnitude;
        MeshStart& start = starts_[i];
        start.known = {magnitude, tolerance(scene_, magnitude), std::nullopt, ray.born_on,
                       ray.is_inside};
        if (ray.knows_side) start.known.depth = ray.is_inside ? 1 : 0;
        geom::SearchedRay& searched = searched_[i];
        searched.ray = shape.transform().to_local(ray.ray);
        searched.search = {.to = ray.farthest,
                           .entering_ends = !ray.is_hidden,
                           .leaving_ends = !ray.is_hidden,
                           .slack = ray.slack,
                           .slack_per_t = ray.slack_per_t};
        begin_ahead(start.known, searched.search, start.own);
        searched.found.clear();
    }
    mesh.crossings({searched_.data(), rays.size()});
    for (std::size_t i = 0; i < rays.size(); ++i) {
        geom::SearchedRay& searched = searched_[i];
        const MeshStart& start = starts_[i];
        const bool is_sure =
            mesh.fits(searched.ray, searched.search, start.known.depth, 0, searched.found) &&
            is_clear_ahead(shape, rays[i].ray, start.known, start.own, searched.found);
        met[i] = is_sure ? told(rays[i], searched) : lanes::MeshMet{};
    }
}

Vec3 LaneHost::put_on_face(const lanes::Solid& solid, geom::Face face, Vec3& point) {
    geom::Ray at{point};
    const Vec3 normal = scene_.parts[std::size_t(solid.part)].shape.put_on_face(face, at).flat;
    point = at.at(0.0);
    return normal;
}

}  // namespace meniscus::tracer
