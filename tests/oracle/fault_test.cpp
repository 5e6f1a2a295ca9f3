// Faults planted in the intersectors are counted as leaks. The linker puts these functions in
// between (--wrap), so the product knows nothing of them.

#include <catch2/catch.hpp>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_shape.hpp"
#include "tests/oracle/scene_builder.hpp"
#include "tests/oracle/segment_check.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

enum class Fault { none, skipped_crossing, flipped_sign, dropped_triangle };

/// Which fault happens, and how often: at each call whose number is a multiple of `every`. Not all
/// of them can be noticed: a crossing may lie behind the ray, or beyond where it ends.
struct Plan {
    Fault fault = Fault::none;
    std::uint64_t every = 1, calls = 0, planted = 0;
    bool is_due() { return fault != Fault::none && ++calls % every == 0; }
};
Plan plan;

void plant(geom::Crossings& crossings, std::size_t first) {
    if (crossings.size() == first) return;
    switch (plan.fault) {
        case Fault::none:
            break;
        case Fault::skipped_crossing:
            if (!plan.is_due()) break;
            ++plan.planted;
            crossings.erase(crossings.size() - 1);
            break;
        case Fault::flipped_sign:
            if (!plan.is_due()) break;
            ++plan.planted;
            crossings[crossings.size() - 1].entering ^= true;
            break;
        case Fault::dropped_triangle:
            for (std::size_t i = crossings.size(); i-- > first;) {
                if (crossings[i].face != 0) continue;
                ++plan.planted;
                crossings.erase(i);
            }
            break;
    }
}

}  // namespace

#define INTERVAL _ZNK8meniscus4geom11PlacedShape8intervalERKNS0_3RayEi
#define CROSSINGS \
    _ZNK8meniscus4geom11PlacedShape9crossingsERKNS0_3RayERNS0_12InlineVectorINS0_8CrossingELm8EEE
#define CROSSINGS_AHEAD \
    _ZNK8meniscus4geom11PlacedShape15crossings_aheadERKNS0_3RayERKNS0_6SearchESt8optionalIiERNS0_12InlineVectorINS0_8CrossingELm8EEE
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define REAL(name) JOIN(__real_, name)
#define WRAP(name) JOIN(__wrap_, name)

#ifdef __clang__
#pragma clang diagnostic ignored "-Wreturn-type-c-linkage"
#endif

extern "C" {

geom::Interval REAL(INTERVAL)(const geom::PlacedShape*, const geom::Ray&, geom::Face);
void REAL(CROSSINGS)(const geom::PlacedShape*, const geom::Ray&, geom::Crossings&);
bool REAL(CROSSINGS_AHEAD)(const geom::PlacedShape*, const geom::Ray&, const geom::Search&,
                           std::optional<int>, geom::Crossings&);

geom::Interval WRAP(INTERVAL)(const geom::PlacedShape* shape, const geom::Ray& ray,
                              geom::Face pin) {
    geom::Interval interval = REAL(INTERVAL)(shape, ray, pin);
    if (interval.hit && plan.fault == Fault::skipped_crossing && plan.is_due()) {
        ++plan.planted;
        return {geom::infinity, -geom::infinity, geom::no_face, geom::no_face, false};
    }
    return interval;
}

void WRAP(CROSSINGS)(const geom::PlacedShape* shape, const geom::Ray& ray,
                     geom::Crossings& crossings) {
    const std::size_t first = crossings.size();
    REAL(CROSSINGS)(shape, ray, crossings);
    plant(crossings, first);
}

bool WRAP(CROSSINGS_AHEAD)(const geom::PlacedShape* shape, const geom::Ray& ray,
                           const geom::Search& search, std::optional<int> depth,
                           geom::Crossings& crossings) {
    const std::size_t first = crossings.size();
    if (!REAL(CROSSINGS_AHEAD)(shape, ray, search, depth, crossings)) return false;
    plant(crossings, first);
    return true;
}
}

namespace {

SceneBuilder room() {
    SceneBuilder builder;
    builder.camera({0.4, 1.3, -6.0}, {0.05, -0.1, 0.0}, 24.0).sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
    return builder;
}

scene::Scene balls() {
    return room()
        .glass(geom::Sphere{{0, 0, 0}, 1.0}, 1.5, 1)
        .glass(geom::Box{{-0.3, -0.4, -0.6}, {0.4, 0.5, 0.3}}, 1.33, 2)
        .scene();
}

scene::Scene meshes() {
    return room().glass(ball_mesh(1.0, 2), 1.5, 1).glass(geom::Torus{0.5, 0.2}, 1.33, 2).scene();
}

tracer::Statistics with(const scene::Scene& scene, Fault fault, std::uint64_t every) {
    plan = {fault, every};
    const auto statistics = rendered(scene).statistics;
    plan.fault = Fault::none;
    return statistics;
}

}  // namespace

TEST_CASE("without a fault there is no leak", "[oracle][fault]") {
    CHECK(with(balls(), Fault::none, 1).leaks == 0);
    CHECK(with(meshes(), Fault::none, 1).leaks == 0);
}

TEST_CASE("a skipped crossing is counted", "[oracle][fault]") {
    for (const auto& scene : {balls(), meshes()}) {
        const auto statistics = with(scene, Fault::skipped_crossing, 97);
        INFO(plan.planted << " planted");
        CHECK(plan.planted > 10);
        CHECK(statistics.leaks * 4 >= plan.planted);
        CHECK(!statistics.first_leaks.empty());
    }
}

TEST_CASE("a flipped sign is counted", "[oracle][fault]") {
    const auto statistics = with(meshes(), Fault::flipped_sign, 97);
    INFO(plan.planted << " planted");
    CHECK(plan.planted > 10);
    CHECK(statistics.leaks * 4 >= plan.planted);
}

TEST_CASE("a dropped triangle is counted", "[oracle][fault]") {
    const auto statistics = with(meshes(), Fault::dropped_triangle, 1);
    INFO(plan.planted << " planted");
    CHECK(plan.planted > 10);
    CHECK(statistics.leaks * 20 >= plan.planted);
    // The mesh is what is blamed.
    CHECK(statistics.leaks_by_object.begin()->first.first == 0);
}

TEST_CASE("from a leak on, a path is right again", "[oracle][fault]") {
    for (const Fault fault : {Fault::skipped_crossing, Fault::flipped_sign}) {
        for (const auto& scene : {balls(), meshes()}) {
            // A walk asks far fewer times than that: none meets a second fault.
            plan = {fault, 499};
            const SegmentCheck check = check_segments(scene, 1, 60000);
            plan.fault = Fault::none;
            INFO(plan.planted << " planted, " << check.leaks << " leaks, " << check.wrong
                              << " points wrong before they were noticed");
            if (plan.planted == 0) continue;  // convex solids have no signs to flip
            CHECK(check.leaks > 10);
            CHECK(check.after_leak > 20);
            CHECK(check.wrong_after_leak == 0);
        }
    }
}
