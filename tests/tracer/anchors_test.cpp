// Which scenes are given a finer contact tolerance than the distance from the origin allows.

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/tracer/scenes.hpp"
#include "tracer/render_scene.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

tracer::RenderScene two(const geom::Shape& a, const geom::Shape& b,
                        const geom::Transform& place = {}) {
    scene::Scene scene;
    add_glass(scene, a, 1.5, 1).transform = place;
    add_glass(scene, b, 1.33, 2).transform = place;
    return tracer::compile(scene);
}

geom::Cylinder tube(const geom::Vec3& base, double height, double radius) {
    return {base, base + geom::Vec3{0.0, height, 0.0}, radius, false};
}

bool says_it_is_skipped(const tracer::RenderScene& scene) {
    return std::ranges::any_of(
        scene.skipped, [](const std::string& text) { return text.find("thin film") != text.npos; });
}

}  // namespace

TEST_CASE("a thin film about one centre far away asks for an anchor", "[tracer][anchor]") {
    const geom::Vec3 far{1048576.0, 0.0, 0.0};
    const auto scene = two(geom::Sphere{far, 1.0}, geom::Sphere{far, 1.0 - 1e-11});
    REQUIRE(scene.anchors.size() == 1);
    CHECK(scene.parts[0].anchor == 0);
    CHECK(scene.parts[1].anchor == 0);
    CHECK(scene.anchors[0].point == far);
    CHECK(scene.anchors[0].size == 1.0);
    CHECK_FALSE(says_it_is_skipped(scene));
}

TEST_CASE("scenes without such a film have no anchors", "[tracer][anchor]") {
    const geom::Vec3 far{1048576.0, 0.0, 0.0};
    // Near the origin; thick; not a film but rounding; about two centres.
    for (const auto& scene :
         {two(geom::Sphere{geom::Vec3{1.0}, 1.0}, geom::Sphere{geom::Vec3{1.0}, 1.0 - 1e-11}),
          two(geom::Sphere{far, 1.0}, geom::Sphere{far, 0.75}),
          two(geom::Sphere{far, 1.0}, geom::Sphere{far, 1.0 - 0x1p-52}),
          two(geom::Sphere{far, 1.0}, geom::Sphere{-far, 1.0 - 1e-11})}) {
        CHECK(scene.anchors.empty());
        CHECK(says_it_is_skipped(scene));
        CHECK(scene.parts[0].anchor == tracer::no_anchor);
    }
}

TEST_CASE("cylinders anywhere along one axis share it, for their sides only", "[tracer][anchor]") {
    const geom::Vec3 far{1048576.0, 0.5, -1048576.0};
    const auto scene = two(tube(far, 2.0, 1.0), tube(far + geom::Vec3{0, 0.25, 0}, 1.0, 1 - 1e-11));
    REQUIRE(scene.anchors.size() == 1);
    CHECK(scene.anchors[0].face == geom::Cylinder::side_face);
    CHECK(scene.anchors[0].size >= 2.0);
    const auto beside =
        two(tube(far, 2.0, 1.0), tube(far + geom::Vec3{0.25, 0.25, 0}, 1.0, 1 - 1e-11));
    CHECK(beside.anchors.empty());
}

TEST_CASE("shapes under one transform far away share their frame", "[tracer][anchor]") {
    const auto place = geom::Transform::rotation_degrees({10.0, 20.0, 30.0})
                           .then(geom::Transform::translation({1e6, 0.0, 0.0}));
    const auto scene = two(geom::Torus{}, geom::Cone{}, place);
    REQUIRE(scene.anchors.size() == 1);
    CHECK(scene.anchors[0].point == geom::Vec3{1e6, 0.0, 0.0});
    CHECK(scene.anchors[0].face == geom::no_face);
}
