// Changes of a scene that must not change its picture.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"
#include "tests/oracle/scene_builder.hpp"
#include "tests/random/random.hpp"
#include "tracer/fresnel.hpp"
#include "tracer/next_event.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

scene::Scene any_scene(std::uint64_t seed) {
    return random_scene(seed, {.rotated = seed % 2 == 1,
                               .cones = true,
                               .tori = true,
                               .lathes = true,
                               .meshes = true,
                               .unions = seed % 3 == 0});
}

SceneBuilder two_balls() {
    SceneBuilder builder;
    builder.camera({0.4, 1.3, -6.0}, {0.05, -0.1, 0.0}, 36.0).sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
    builder.glass(geom::Sphere{{-0.5, 0, 0}, 0.9}, 1.5, 2, {0.1, 0.2, 0.3})
        .glass(geom::Sphere{{0.5, 0.1, 0}, 0.9}, 1.33, 1, {0.2, 0.1, 0.0});
    return builder;
}

/// Both pictures show the same: pixels differ by more than 1e-6 only where the exact picture jumps.
void check_same(const tracer::Rendered& a, const tracer::Rendered& b, const scene::Scene& scene,
                const Picture& picture) {
    const Change change = oracle::change(a, b, scene, picture, 1e-6);
    INFO(change.off << " pixels differ, " << change.unexplained << " without a reason");
    CHECK(b.statistics.leaks == 0);
    CHECK(change.unexplained == 0);
}

}  // namespace

TEST_CASE("priorities may be any numbers in the same order", "[oracle][metamorphic]") {
    const std::uint64_t seed = GENERATE(range(3000, 3008));
    auto scene = any_scene(seed);
    const auto before = rendered(scene);
    for (scene::Solid& solid : scene.solids)
        solid.interior.priority = std::atan(solid.interior.priority - 3.0) * 1e6;
    CHECK(rendered(scene).picture.rgb == before.picture.rgb);
}

TEST_CASE("a solid hidden within one of higher priority is not seen", "[oracle][metamorphic]") {
    const auto plain = rendered(two_balls().scene());
    const double radius = GENERATE(0.5, 0.875);
    auto more = two_balls();
    more.glass(geom::Sphere{{-0.5, 0, 0}, radius}, 2.4, 1.5, scene::Rgb{0.9});
    CHECK(rendered(more.scene()).picture.rgb == plain.picture.rgb);
    auto mesh = two_balls();
    mesh.glass(geom::Torus{0.4, 0.2}, 2.4, 0, scene::Rgb{0.9},
               geom::Transform::translation({-0.5, 0, 0}));
    CHECK(rendered(mesh.scene()).picture.rgb == plain.picture.rgb);
}

TEST_CASE("a solid may be made of two in contact, of like media", "[oracle][metamorphic]") {
    const auto builder = [] {
        SceneBuilder b;
        b.camera({1.4, 1.9, -4.0}, {0.05, -0.1, 0.0}, 40.0).sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
        b.glass(geom::Sphere{{0.3, 0.2, 0.1}, 0.5}, 1.33, 9, {0.3, 0.0, 0.3});
        return b;
    };
    const scene::Rgb amber{0.1, 0.2, 0.3};
    const auto turn = geom::Transform::rotation_degrees({11, 22, 33});
    auto whole = builder();
    whole.glass(geom::Box{{-1, -1, -1}, {1, 1, 1}}, 1.5, 1, amber, turn);
    auto halves = builder();
    halves.glass(geom::Box{{-1, -1, -1}, {0.1, 1, 1}}, 1.5, 1, amber, turn)
        .glass(geom::Box{{0.1, -1, -1}, {1, 1, 1}}, 1.5, 2, amber, turn);
    // A path has the segments of both halves, so the limit on its depth must not be felt.
    const Picture picture{.limits = {.depth = 60, .cutoff = 1e-3}};
    check_same(rendered(whole.scene(), picture), rendered(halves.scene(), picture), whole.scene(),
               picture);
}

TEST_CASE("a picture does not depend on the unit of length", "[oracle][metamorphic]") {
    const double unit = GENERATE(0x1p-20, 0x1p20);
    for (const std::uint64_t seed : {1u, 2u, 3u, 5u, 8u, 13u}) {
        CAPTURE(seed, unit);
        RandomSceneOptions options{.rotated = seed % 2 == 1, .cones = true, .meshes = true};
        const auto scene = random_scene(seed, options);
        options.scale = unit;
        check_same(rendered(scene), rendered(random_scene(seed, options)), scene, {});
    }
}

TEST_CASE("a picture does not depend on the place", "[oracle][metamorphic]") {
    for (const std::uint64_t seed : {1u, 2u, 3u, 5u, 8u, 13u}) {
        CAPTURE(seed);
        RandomSceneOptions options{.cones = true, .tori = true, .floor = false};
        const auto scene = random_scene(seed, options);
        options.offset = {0x1p10, -0x1p11, 0x1p9};  // rounding moves the camera by 1e-13
        check_same(rendered(scene), rendered(random_scene(seed, options)), scene, {});
    }
}

TEST_CASE("light goes back the way it came", "[oracle][metamorphic]") {
    // Through refracting surfaces only, to the open: from there back, the same shares get through.
    std::size_t paths = 0;
    for (std::uint64_t seed = 3100; seed < 3120; ++seed) {
        const auto scene = tracer::compile(any_scene(seed));
        tracer::Options options;
        tracer::Statistics statistics;
        tracer::EventFinder finder(scene, options, statistics);
        struct Way {
            bool is_through = false;
            double share = 1.0;
            geom::Vec3 end{0.0}, direction{0.0};
            std::size_t surfaces = 0;
        };
        // Behind `goal`, where the way began that is gone back, other things may stand.
        const auto is_behind = [](const geom::Vec3& goal, const tracer::TracedRay& ray, double t) {
            const geom::Vec3 way = goal - ray.ray.origin;
            const double along = glm::dot(way, ray.ray.direction);
            return t > along && along > 0.0 && glm::length(way - along * ray.ray.direction) < 1e-6;
        };
        const auto follow = [&](geom::Ray start, double reach, const geom::Vec3* goal) {
            Way way;
            tracer::TracedRay ray = finder.start(start, tracer::RayKind::image);
            for (; way.surfaces < 30; ++way.surfaces) {
                const auto event = finder.next(ray);
                way.direction = ray.ray.direction;
                if (!event || (goal && is_behind(*goal, ray, event->t))) {
                    way.is_through = (event ? event->before : ray.interior).empty();
                    way.end = ray.ray.at(reach);
                    return way;
                }
                if (scene.parts[event->skin].is_opaque) return way;
                geom::Vec3 n = event->normal;
                const geom::Vec3 d = ray.ray.direction;
                if (glm::dot(n, d) > 0.0) n = -n;
                const double eta = medium(scene, event->solid_before).ior /
                                   tracer::medium(scene, event->solid_after).ior;
                const auto refracted = tracer::refract(d, n, eta);
                if (!refracted) return way;
                way.share *= 1.0 - tracer::fresnel_reflectance(eta, -glm::dot(n, d));
                ray.ray = event->origin;
                ray.ray.direction = *refracted;
                ray.interior = event->after;
                ray.contacts = event->contacts;
                ray.birth = event->birth;
            }
            return way;
        };
        Random random(seed);
        for (int i = 0; i < 100; ++i) {
            geom::Ray ray;
            ray.origin = 9.0 * random.direction();
            ray.direction = glm::normalize(random.point(-1.0, 1.0) - ray.origin);
            if (!finder.start(ray, tracer::RayKind::image).interior.empty()) continue;
            const Way there = follow(ray, 20.0, nullptr);
            if (!there.is_through || there.surfaces == 0 || there.share < 0.3) continue;
            const Way back =
                follow({there.end, -there.direction, geom::Vec3{0.0}}, 1.0, &ray.origin);
            INFO("seed " << seed << ", ray " << i);
            CHECK(back.is_through);
            CHECK(back.surfaces == there.surfaces);
            CHECK(back.share == Approx(there.share).epsilon(1e-8));
            CHECK(geom::max_abs(back.direction + ray.direction) < 1e-8);
            ++paths;
        }
        CHECK(statistics.leaks == 0);
    }
    CHECK(paths > 150);
}
