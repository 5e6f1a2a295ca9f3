#include "tests/oracle/segment_check.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "tests/oracle/world.hpp"
#include "tests/random/random.hpp"
#include "tracer/fresnel.hpp"
#include "tracer/next_event.hpp"

namespace meniscus::oracle {
namespace {

using V = Vector<Quad>;

bool is_there(const World<Quad>& world, const V& p, int solid, Quad margin) {
    if (world.solid_at(p) == solid) return true;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            V beside = p;
            (axis == 0 ? beside.x : axis == 1 ? beside.y : beside.z) += sign * margin;
            if (world.solid_at(beside) == solid) return true;
        }
    }
    return false;
}

}  // namespace

SegmentCheck check_segments(const scene::Scene& source, std::uint64_t seed,
                            std::uint64_t segments) {
    const auto scene = tracer::compile(source);
    const World<Quad> world(source);
    const tracer::Options options;
    tracer::Statistics statistics;
    tracer::EventFinder finder(scene, options, statistics);
    const geom::Vec3 eye = source.camera.location;
    const double reach = std::max(scene.size, glm::length(eye));
    Random random(seed);
    SegmentCheck check;
    while (check.segments < segments) {
        geom::Ray start;
        start.origin = eye;
        start.direction = random.chance(0.3)
                              ? random.direction()
                              : glm::normalize(source.camera.direction +
                                               random.between(-0.5, 0.5) * source.camera.right +
                                               random.between(-0.5, 0.5) * source.camera.up);
        tracer::TracedRay ray = finder.start(start, tracer::RayKind::image);
        const std::uint64_t leaks_before = statistics.leaks;
        for (int bounce = 0; bounce < 12 && check.segments < segments; ++bounce) {
            const auto event = finder.next(ray);
            const int listed = event ? event->solid_before : ray.interior.top_solid(scene);
            // Beyond the last surface only a stretch as long as the scene is of interest. (The list
            // is the one at infinity there.)
            const double t = random.between(0.0, event ? event->t : reach);
            const auto& r = ray.ray;
            const V p = (widen<Quad>(r.origin) + widen<Quad>(r.origin_error)) +
                        Quad(t) * widen<Quad>(r.direction);
            const bool is_wrong = !is_there(world, p, listed, Quad(1e-9 * reach));
            ++check.segments;
            check.wrong += is_wrong;
            if (statistics.leaks > leaks_before) {
                ++check.after_leak;
                check.wrong_after_leak += is_wrong;
            }
            if (!event || scene.parts[event->skin].is_opaque) break;

            const geom::Vec3 d = r.direction;
            const geom::Vec3 n = glm::dot(event->normal, d) > 0.0 ? -event->normal : event->normal;
            const double eta = tracer::medium(scene, event->solid_before).ior /
                               tracer::medium(scene, event->solid_after).ior;
            const auto refracted = tracer::refract(d, n, eta);
            const bool goes_through = refracted && random.chance(0.7);
            ray.ray = event->origin;
            ray.ray.direction = goes_through ? *refracted : tracer::reflect(d, n);
            ray.interior = goes_through ? event->after : event->before;
            ray.contacts = event->contacts;
            ray.birth = event->birth;
        }
    }
    check.leaks = statistics.leaks;
    return check;
}

}  // namespace meniscus::oracle
