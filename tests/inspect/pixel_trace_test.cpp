#include "inspect/pixel_trace.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "tests/inspect/scenes.hpp"

using namespace meniscus;
using namespace meniscus::test;
using tracer::TreeNode;

TEST_CASE("a ray through glass over water meets the lists of the paper's second figure",
          "[inspect]") {
    const Traced traced(glass_over_water(), ray({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}));
    const auto path = traced.refracted_path();
    REQUIRE(path.size() == 4);

    std::vector<std::string> lists;
    std::vector<bool> verdicts;
    for (const auto* segment : path) {
        for (const auto& step : segment->steps) {
            lists.push_back(traced.list(step.before));
            verdicts.push_back(step.is_true);
        }
    }
    lists.push_back(traced.list(path.back()->start));
    CHECK(lists == std::vector<std::string>{"empty", "Glass", "Glass, Water", "Water", "empty"});
    CHECK(verdicts == std::vector<bool>{true, false, true, true});

    const auto& inside_glass = *path[1];
    CHECK(inside_glass.steps[0].why[0] ==
          "Water (priority 1) is below Glass (priority 2), which is there");
    CHECK(inside_glass.steps[1].why[0] == "Glass (priority 2) ends and Water (priority 1) is next");
    CHECK(path[0]->steps[0].why[0] == "Glass (priority 2) replaces the outside");
}

TEST_CASE("reflectance and transmittance are Fresnel's at each surface", "[inspect]") {
    const Traced straight(glass_over_water(), ray({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}));
    const auto path = straight.refracted_path();
    CHECK(path[0]->node.reflectance.r == Approx(0.04));
    CHECK(path[0]->node.transmittance.r == Approx(0.96));
    CHECK(path[1]->node.ior_before == 1.5);
    CHECK(path[1]->node.ior_after == 1.33);
    CHECK(path[1]->node.reflectance.r == Approx(std::pow(0.17 / 2.83, 2)));
    CHECK(path[2]->node.reflectance.r == Approx(std::pow(0.33 / 2.33, 2)));

    // At 45 degrees the reflectance for p-polarised light is the square of that for s.
    const Traced oblique(glass_over_water(), ray({0.0, 0.0, -1.0}, {0.0, 1.0, 1.0}));
    const auto& node = oblique.trace.segments[0].node;
    CHECK(node.angle_degrees == Approx(45.0));
    CHECK(node.reflectance.r == Approx(0.5 * (0.0920134 + 0.0920134 * 0.0920134)).epsilon(1e-5));
}

TEST_CASE("glass reflects totally beyond 41.81 degrees", "[inspect]") {
    scene::Scene scene;
    add_medium(scene, "Glass", geom::Plane{{0.0, 0.0, 1.0}, 0.0}, 1.5, 0.0);
    const auto from_inside = [&](double degrees) {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        return Traced(scene, ray({0.0, 0.0, -1.0}, {std::sin(angle), 0.0, std::cos(angle)}));
    };
    const auto below = from_inside(41.8);
    CHECK(below.list(below.trace.segments[0].start) == "Glass");
    CHECK_FALSE(below.trace.segments[0].node.total_reflection);
    const auto above = from_inside(41.82);
    CHECK(above.trace.segments[0].node.total_reflection);
    CHECK(above.trace.segments[0].node.reflectance.r == 1.0);
    for (const auto& segment : above.trace.segments)
        CHECK((segment.node.parent != 0 || segment.node.branch == TreeNode::Branch::reflected));
}

TEST_CASE("surfaces that coincide are one step", "[inspect]") {
    scene::Scene scene;
    add_medium(scene, "Glass", geom::Box{{-9.0, -9.0, 0.0}, {9.0, 9.0, 2.0}}, 1.5, 2.0);
    add_medium(scene, "Water", geom::Box{{-9.0, -9.0, 2.0}, {9.0, 9.0, 4.0}}, 1.33, 1.0);
    const Traced traced(scene, ray({0.0, 0.0, -1.0}, {0.1, 0.0, 1.0}));
    const auto path = traced.refracted_path();
    REQUIRE(path[1]->steps.size() == 1);
    const auto& step = path[1]->steps[0];
    CHECK(step.crossings.size() == 2);
    CHECK(step.is_true);
    CHECK(traced.list(step.before) == "Glass");
    CHECK(traced.list(step.after) == "Water");
    CHECK(step.why[0] ==
          "2 crossings in this place are one: Glass (priority 2) gives way to Water (priority 1)");
}

TEST_CASE("what a medium absorbs on the way is told", "[inspect]") {
    auto scene = glass_over_water();
    scene.solids[0].interior.absorption = {0.0, 0.5, 1.0};
    const Traced traced(scene, ray({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}));
    const auto& in_glass = *traced.refracted_path()[1];
    CHECK(in_glass.way == Approx(2.0));
    CHECK(in_glass.absorption.r == 1.0);
    CHECK(in_glass.absorption.g == Approx(std::exp(-1.0)));
    CHECK(in_glass.absorption.b == Approx(std::exp(-2.0)));
}

TEST_CASE("the boundary of like media is passed, and the way goes on", "[inspect]") {
    scene::Scene scene;
    for (const double z : {0.0, 2.0}) {
        auto& object =
            add_medium(scene, "Glass", geom::Box{{-9.0, -9.0, z}, {9.0, 9.0, z + 2.0}}, 1.5, 0.0);
        scene.solids[object.solid].interior.absorption = scene::Rgb{0.25};
    }
    const Traced traced(scene, ray({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}));
    const auto path = traced.refracted_path();
    CHECK_FALSE(path[1]->node.is_surface);
    CHECK(path[2]->node.branch == TreeNode::Branch::straight);
    CHECK(path[2]->way == Approx(4.0));
    CHECK(path[2]->absorption.r == Approx(std::exp(-1.0)));
    // Two solids of one name are told apart by their lines.
    CHECK(traced.list(path[2]->start) == "Glass@2");
}

TEST_CASE("what the segments add is the pixel's colour", "[inspect]") {
    auto scene = glass_over_water();
    scene.solids[1].interior.absorption = {0.3, 0.2, 0.1};
    add_opaque(scene, "Stone", geom::Sphere{{0.0, 1.0, 6.0}, 2.0});
    const Traced traced(scene, ray({0.0, 0.0, -2.0}, {0.05, 0.1, 1.0}));
    scene::Rgb sum{0.0};
    for (const auto& segment : traced.trace.segments) sum += segment.adds;
    for (int i = 0; i < 3; ++i) CHECK(sum[i] == Approx(traced.trace.color[i]));
    CHECK(traced.trace.color.r > 0.0);
    CHECK(traced.trace.leaks == 0);
}

TEST_CASE("the replayed list is the tracer's own in any crowd of solids", "[inspect]") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto somewhere = [&] { return Vec3{uniform(random), uniform(random), uniform(random)}; };
    scene::Scene scene;
    for (int i = 0; i < 12; ++i) {
        auto& object = add_medium(scene, "Ball", geom::Sphere{somewhere(), 0.8 + 0.3 * i / 12.0},
                                  1.2 + 0.05 * i, i % 5);
        object.inverse = i == 11;
    }
    for (const auto mode :
         {tracer::InteriorMode::sweep, tracer::InteriorMode::recast, tracer::InteriorMode::off}) {
        auto options = Traced::whitted();
        options.interior = mode;
        int surfaces = 0;
        for (int i = 0; i < 50; ++i) {
            const Vec3 from = 3.0 * somewhere();
            const Traced traced(scene, ray(from, somewhere() - from), options);
            for (const auto& segment : traced.trace.segments) {
                if (!segment.ends_at_surface()) continue;
                ++surfaces;
                const auto& event = segment.node.event;
                REQUIRE(segment.steps.back().is_true);
                CHECK(segment.steps.back().before == inspect::listing(traced.scene, event.before));
                CHECK(segment.steps.back().after == inspect::listing(traced.scene, event.after));
                CHECK(segment.steps.back().before.top == event.solid_before);
                CHECK(segment.steps.back().after.top == event.solid_after);
            }
        }
        CHECK(surfaces > 100);
    }
}
