// Rays aimed at what ends, touches or turns away, and beside it.

#include <catch2/catch.hpp>

#include "tests/oracle/aimed_rays.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

const geom::Vec3 turned{31.0, -47.0, 112.0};

}  // namespace

TEST_CASE("no ray leaks, at whatever distance from an edge", "[oracle][aimed]") {
    const auto aim = Aim(GENERATE(range(0, aims)));
    AimedScene straight_scene(geom::Vec3{0.0}), turned_scene(turned);
    std::uint64_t segments = 0;
    for (const double beside : {0.0, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6}) {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            for (AimedScene* scene : {&straight_scene, &turned_scene}) {
                const AimedRay ray = follow(scene->aimed(aim, beside, seed));
                INFO(name(aim) << ", " << beside << " beside, seed " << seed);
                CHECK(ray.leaks == 0);
                segments += ray.segments;
            }
        }
    }
    CHECK(segments >= 800);
}

TEST_CASE("nearer to an edge colours are exact for rays within rounding", "[oracle][aimed]") {
    const auto aim = Aim(GENERATE(range(0, aims)));
    AimedScene straight_scene(geom::Vec3{0.0}), turned_scene(turned);
    for (const double beside : {0.0, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10}) {
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            for (AimedScene* scene : {&straight_scene, &turned_scene}) {
                const AimedRay ray = compared(scene->aimed(aim, beside, seed));
                INFO(name(aim) << ", " << beside << " beside, seed " << seed << ": off by "
                               << ray.difference);
                CHECK(ray.is_explained);
            }
        }
    }
}

TEST_CASE("colours are exact from 1e-5 beside an edge on", "[oracle][aimed]") {
    const auto aim = Aim(GENERATE(range(0, aims)));
    AimedScene straight_scene(geom::Vec3{0.0}), turned_scene(turned);
    for (const double beside : {1e-5, 1e-4}) {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            for (AimedScene* scene : {&straight_scene, &turned_scene}) {
                const AimedRay ray = compared(scene->aimed(aim, beside, seed));
                INFO(name(aim) << ", " << beside << " beside, seed " << seed);
                CHECK(ray.difference < 1e-6);
            }
        }
    }
}
