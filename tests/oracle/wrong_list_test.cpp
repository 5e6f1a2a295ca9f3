#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/oracle/random_shape.hpp"
#include "tests/oracle/scene_builder.hpp"
#include "tracer/next_event.hpp"

// A ray whose list is wrong is found out where it starts, and goes on as if it had been right.

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

constexpr int odd = 0;  // the part that is put into lists where it is not, and taken out

/// A solid in front of a ball, under an open sky.
scene::Scene around(const geom::Shape& shape, const geom::Transform& transform = {}) {
    return SceneBuilder()
        .camera({0, 0, -6}, {0, 0, 0}, 30.0)
        .glass(shape, 1.5, 1, scene::Rgb{0.0}, transform)
        .glass(geom::Sphere{{0.3, -0.2, 3.0}, 1.2}, 1.33, 2)
        .scene();
}

std::vector<scene::Scene> scenes() {
    const auto askew = geom::Transform::scaling({1.0, 0.7, 1.3})
                           .then(geom::Transform::rotation_degrees({20, 30, 40}))
                           .then(geom::Transform::translation({0.1, 0.2, -0.3}));
    std::vector<scene::Scene> result;
    for (const geom::Transform& transform : {geom::Transform{}, askew}) {
        for (const geom::Shape& shape :
             {geom::Shape{geom::Sphere{}}, geom::Shape{geom::Box{{-0.7, -0.8, -0.9}, {0.6, 1, 1}}},
              geom::Shape{geom::Cylinder{{0, -1, 0}, {0, 1, 0.2}, 0.8}},
              geom::Shape{geom::Cone{{0, -1, 0}, 1.0, {0, 1, 0}, 0.2}},
              geom::Shape{geom::Plane{{0.2, 1, 0.1}, 0.1}}, geom::Shape{geom::Torus{1.0, 0.4}},
              geom::Shape{geom::Lathe{}}, geom::Shape{ball_mesh(1.0, 1)}}) {
            result.push_back(around(shape, transform));
        }
    }
    return result;
}

void toggle(tracer::InteriorList& list) { list.inside(odd) ? list.leave(odd) : list.enter(odd); }

struct Way {
    std::optional<tracer::Event> event;
    int solid_at_end = tracer::outside;
    tracer::Statistics statistics;
};

/// Where a ray's medium changes next, its list being right or not.
Way way(const tracer::RenderScene& scene, const geom::Ray& ray, bool wrong) {
    const tracer::Options options;
    Way result;
    tracer::EventFinder finder(scene, options, result.statistics);
    tracer::TracedRay traced = finder.start(ray, tracer::RayKind::image);
    if (wrong) toggle(traced.interior);
    result.event = finder.next(traced);
    result.solid_at_end = traced.interior.top_solid(scene);
    return result;
}

/// Both see the same.
void check_same(const Way& a, const Way& b) {
    REQUIRE(a.event.has_value() == b.event.has_value());
    CHECK(a.solid_at_end == b.solid_at_end);
    if (!a.event) return;
    CHECK(a.event->t == b.event->t);
    CHECK(a.event->part == b.event->part);
    CHECK(a.event->solid_before == b.event->solid_before);
    CHECK(a.event->solid_after == b.event->solid_after);
}

}  // namespace

TEST_CASE("a wrong list is a leak wherever the ray starts, and the way goes on right", "[oracle]") {
    Random random(1);
    for (const scene::Scene& source : scenes()) {
        const auto scene = tracer::compile(source);
        REQUIRE(scene.parts.size() == 2);
        const std::string name = source.objects[odd].name;
        int entered = 0, forgotten = 0;
        for (int i = 0; i < 2000; ++i) {
            geom::Ray ray;
            ray.origin = random.point(-2.0, 2.0);
            ray.direction = random.direction();
            const bool is_inside = scene.parts[odd].shape.contains(ray.origin);
            const Way right = way(scene, ray, false), wrong = way(scene, ray, true);
            // A mesh is asked no farther than to the next event: its list may be found out later.
            const bool is_asked_late =
                std::holds_alternative<geom::Mesh>(scene.parts[odd].shape.shape()) && right.event &&
                right.event->part != odd;
            if (is_asked_late && wrong.statistics.leaks == 0) continue;
            ++(is_inside ? forgotten : entered);
            INFO(name << ", ray " << i << (is_inside ? ", inside" : ", outside"));
            CHECK(right.statistics.leaks == 0);
            REQUIRE(wrong.statistics.leaks > 0);
            CHECK(wrong.statistics.first_leaks[0].object == odd);
            CHECK(wrong.statistics.first_leaks[0].position == ray.origin);
            check_same(wrong, right);
        }
        INFO(name);
        CHECK(entered > 100);
        CHECK(forgotten > 20);
    }
}

TEST_CASE("a list that holds what a ray only passes is a leak", "[oracle]") {
    // Lines that miss: no interval, but the solid in the list would be left somewhere ahead.
    const auto leaks = [](const geom::Shape& shape, const geom::Vec3& o, const geom::Vec3& d) {
        const auto scene = tracer::compile(around(shape));
        const Way wrong = way(scene, {o, d}, true);
        check_same(wrong, way(scene, {o, d}, false));
        CHECK(wrong.statistics.leaks_by_object.begin()->first ==
              std::pair{std::size_t(odd), std::string("forced crossing")});
        return wrong.statistics.leaks;
    };
    const geom::Vec3 across{1, 0, 0};
    CHECK(leaks(geom::Sphere{}, {-5, 2, 0}, across) > 0);
    CHECK(leaks(geom::Box{{-1, -1, -1}, {1, 1, 1}}, {-5, 2, 0}, across) > 0);
    CHECK(leaks(geom::Box{{-1, -1, -1}, {1, 1, 1}}, {-5, 1, 0}, across) > 0);  // along its top
    CHECK(leaks(geom::Cylinder{{0, -1, 0}, {0, 1, 0}, 1.0}, {-5, 2, 0}, across) > 0);
    CHECK(leaks(geom::Cone{{0, -1, 0}, 1.0, {0, 1, 0}, 0.0}, {-5, 2, 0}, across) > 0);
    CHECK(leaks(geom::Plane{{0, 1, 0}, 0.0}, {-5, 2, 0}, across) > 0);  // never meets it
}

TEST_CASE("a list is right within rounding of a surface, and in solids that are hardly there",
          "[oracle]") {
    // Each origin is 2 u M above the solid that its list holds, each direction along its face.
    for (const double offset : {0.0, 1.0, 1000.0}) {
        const double hair = 0x1p-52 * (offset + 1.0);
        for (const double thickness : {1.0, 40.0 * hair}) {
            const auto scene =
                tracer::compile(around(geom::Box{{-1, offset - thickness, -1}, {1, offset, 1}}));
            const tracer::Options options;
            tracer::Statistics statistics;
            tracer::EventFinder finder(scene, options, statistics);
            for (const geom::Vec3& d : {geom::Vec3{1, 0, 0}, geom::Vec3{0.6, 0, 0.8}}) {
                tracer::TracedRay ray;
                ray.ray = {{0.1, offset + hair, 0.2}, d};
                ray.birth.magnitude = offset + 1.0;
                ray.interior.enter(odd);
                finder.next(ray);
            }
            INFO("at " << offset << ", " << thickness << " thick");
            CHECK(statistics.leaks == 0);
        }
    }
}
