#include "benchmarks/known_rays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace meniscus::geom {
namespace {

Search search_of(const KnownRay& known) {
    return {.from = 0.0,
            .entering_ends = true,
            .leaving_ends = true,
            .slack = 1e-7,
            .slack_per_t = 1e-7,
            .own = known.born_on};
}

Nearest first_of(const Crossings& found, const KnownRay& known) {
    for (const Crossing& crossing : found) {
        if (crossing.t > 0.0 && crossing.face != known.born_on) return {crossing.t, crossing.face};
    }
    return {};
}

class Random {
public:
    double next() { return static_cast<double>(engine_()) / 4294967296.0; }
    Vec3 direction() {
        const double z = 2.0 * next() - 1.0, a = 2.0 * std::numbers::pi * next();
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(a), r * std::sin(a), z};
    }

private:
    std::mt19937 engine_{7};
};

Ray camera_ray(int i, int width) {
    const double x = (i % width + 0.5) / width - 0.5, y = 0.5 - (i / width + 0.5) / width;
    return {{0.3, 2.2, -2.6}, glm::normalize(Vec3{1.1 * x - 0.1, 1.1 * y - 0.85, 1.0})};
}

/// Where a ray arrives, as the origin of the next.
Ray arrived(const TriangleMesh& mesh, const Ray& ray, const Nearest& hit) {
    Ray next{ray.at(hit.t), {}};
    next.origin_error = mesh.to_face(hit.face, next);
    return next;
}

}  // namespace

Nearest nearest(const TriangleMesh& mesh, const KnownRay& known, Crossings& found) {
    found.clear();
    if (!mesh.crossings_ahead(known.ray, search_of(known), known.depth, found)) {
        found.clear();
        mesh.crossings(known.ray, found);
    }
    return first_of(found, known);
}

void InTurns::nearest(const TriangleMesh& mesh, std::span<const KnownRay> rays, Nearest* result) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        searched_[i].ray = rays[i].ray;
        searched_[i].search = search_of(rays[i]);
        searched_[i].found.clear();
    }
    mesh.crossings({searched_.data(), rays.size()});
    for (std::size_t i = 0; i < rays.size(); ++i) {
        SearchedRay& one = searched_[i];
        if (mesh.fits(one.ray, one.search, rays[i].depth, 0, one.found)) {
            result[i] = first_of(one.found, rays[i]);
            continue;
        }
        found_.clear();
        mesh.crossings(rays[i].ray, found_);
        result[i] = first_of(found_, rays[i]);
    }
}

std::vector<KnownRay> primary_rays(int count) {
    const int width = static_cast<int>(std::sqrt(count));
    std::vector<KnownRay> rays;
    for (int i = 0; i < width * width; ++i) rays.push_back({camera_ray(i, width)});
    return rays;
}

std::vector<KnownRay> diffuse_rays(const TriangleMesh& mesh, int count) {
    Random random;
    Crossings found;
    std::vector<KnownRay> rays;
    const int width = static_cast<int>(std::sqrt(count));
    while (static_cast<int>(rays.size()) < count) {
        const KnownRay camera{camera_ray(static_cast<int>(random.next() * width * width), width)};
        const Nearest hit = nearest(mesh, camera, found);
        if (hit.face == no_face) continue;
        KnownRay inwards{arrived(mesh, camera.ray, hit), 1, hit.face};
        inwards.ray.direction = random.direction();
        if (glm::dot(inwards.ray.direction, mesh.normal(hit.face)) > 0.0)
            inwards.ray.direction *= -1.0;
        rays.push_back(inwards);
    }
    return rays;
}

std::vector<KnownRay> glass_chain(const TriangleMesh& mesh, int count) {
    Random random;
    Crossings found;
    std::vector<KnownRay> rays;
    const int width = static_cast<int>(std::sqrt(count));
    while (static_cast<int>(rays.size()) < count) {
        KnownRay known{camera_ray(static_cast<int>(random.next() * width * width), width)};
        for (int segment = 0; segment < 16; ++segment) {
            rays.push_back(known);
            const Nearest hit = nearest(mesh, known, found);
            if (hit.face == no_face) break;
            const Vec3 d = known.ray.direction;
            Vec3 n = mesh.normal(hit.face);
            if (glm::dot(n, d) > 0.0) n = -n;
            const double eta = known.depth > 0 ? 1.5 : 1.0 / 1.5, ci = -glm::dot(n, d);
            const double st2 = eta * eta * (1.0 - ci * ci),
                         ct = std::sqrt(std::max(0.0, 1.0 - st2));
            const double rs = (eta * ci - ct) / (eta * ci + ct),
                         rp = (ci - eta * ct) / (ci + eta * ct);
            const bool reflects = st2 >= 1.0 || random.next() < 0.5 * (rs * rs + rp * rp);
            known.ray = arrived(mesh, known.ray, hit);
            known.ray.direction =
                glm::normalize(reflects ? d + 2.0 * ci * n : eta * d + (eta * ci - ct) * n);
            known.born_on = hit.face;
            if (!reflects) known.depth = 1 - known.depth;
        }
    }
    rays.resize(static_cast<std::size_t>(count));
    return rays;
}

}  // namespace meniscus::geom
