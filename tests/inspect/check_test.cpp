#include <catch2/catch.hpp>

#include "tests/inspect/checked.hpp"

using namespace meniscus;
using namespace meniscus::test;

TEST_CASE("a healthy scene has no findings", "[inspect]") {
    auto scene = glass_over_water();
    add_opaque(scene, "Floor", geom::Plane{{0.0, 1.0, 0.0}, -20.0});
    scene.lights.push_back({.position = {10.0, 10.0, -10.0}, .location = {}});
    CHECK(check(scene).empty());
}

TEST_CASE("an ellipsoid within a ball of higher priority is hidden", "[inspect]") {
    const auto with_ellipsoid = [](const Vec3& axes) {
        auto scene = seen_from_afar();
        add_medium(scene, "Glass", geom::Sphere{Vec3{0.0}, 1.0}, 1.5, 2.0);
        add_medium(scene, "Water", geom::Sphere{Vec3{0.0}, 1.0}, 1.33, 1.0);
        scene.objects.back().transform = geom::Transform::scaling(axes);
        return lints(check(scene));
    };
    CHECK(with_ellipsoid({0.9, 0.9, 0.8}) == Lints{"hidden-solid"});
    CHECK(with_ellipsoid({0.9, 1.1, 0.8}).empty());
}

TEST_CASE("a solid wholly inside one of higher priority is never there", "[inspect]") {
    using geom::Shape;
    const Vec3 up{0.0, 1.0, 0.0};
    const auto [inner, outer, is_hidden] = GENERATE_COPY(table<Shape, Shape, bool>({
        {geom::Sphere{{0.0, 0.5, 0.0}, 0.5}, geom::Sphere{Vec3{0.0}, 1.0}, true},  // touching
        {geom::Sphere{{0.0, 0.5, 0.0}, 0.51}, geom::Sphere{Vec3{0.0}, 1.0}, false},
        {geom::Box{Vec3{-0.57}, Vec3{0.57}}, geom::Sphere{Vec3{0.0}, 1.0}, true},
        {geom::Box{Vec3{-0.58}, Vec3{0.58}}, geom::Sphere{Vec3{0.0}, 1.0}, false},
        {geom::Cylinder{-0.5 * up, 0.5 * up, 0.86}, geom::Sphere{Vec3{0.0}, 1.0}, true},
        {geom::Cylinder{-0.5 * up, 0.5 * up, 0.87}, geom::Sphere{Vec3{0.0}, 1.0}, false},
        {geom::Cylinder{-up, up, 0.9}, geom::Cylinder{-up, up, 1.0}, true},
        {geom::Cylinder{-up, 1.01 * up, 0.9}, geom::Cylinder{-up, up, 1.0}, false},
        {geom::Torus{0.7, 0.25}, geom::Cylinder{-up, up, 1.0}, true},
        {geom::Torus{0.8, 0.25}, geom::Cylinder{-up, up, 1.0}, false},
        {geom::Sphere{{5.0, -1.0, 3.0}, 1.0}, geom::Plane{up, 0.0}, true},
        {geom::Sphere{{5.0, -0.9, 3.0}, 1.0}, geom::Plane{up, 0.0}, false},
        {geom::Sphere{Vec3{0.0}, 0.5}, geom::Torus{0.7, 0.25}, false},
        {geom::Sphere{{0.7, 0.0, 0.0}, 0.2}, geom::Torus{0.7, 0.25}, true},  // by sampling
    }));
    auto scene = seen_from_afar();
    scene.camera.location = {0.0, 90.0, 0.0};
    add_medium(scene, "Inner", inner, 1.33, 1.0);
    add_medium(scene, "Outer", outer, 1.5, 2.0);
    CAPTURE(geom::keyword(inner), geom::keyword(outer));
    const auto findings = check(scene);
    REQUIRE(lints(findings) == (is_hidden ? Lints{"hidden-solid"} : Lints{}));
    if (!is_hidden) return;
    CHECK(findings[0].location.line == 1);
    CHECK(findings[0].advice == "to make it visible, give it `priority 3` or more");
    const bool is_sampled =
        findings[0].text.find("as far as sample lines show") != std::string::npos;
    CHECK(is_sampled == std::holds_alternative<geom::Torus>(outer));

    SECTION("unless its own priority is higher") {
        scene.solids[0].interior.priority = 3.0;
        CHECK(check(scene).empty());
    }
    SECTION("moved and turned alike") {
        for (auto& object : scene.objects)
            object.transform = geom::Transform::rotation_degrees({10.0, 20.0, 30.0})
                                   .then(geom::Transform::translation({-3.0, -40.0, 1.0}));
        CHECK(lints(check(scene)) == Lints{"hidden-solid"});
    }
}

TEST_CASE("an interior on what is never a solid is found", "[inspect]") {
    auto scene = seen_from_afar();
    add_medium(scene, "Lid", geom::Disc{}, 1.5, 1.0);
    geom::Cylinder tube;
    tube.open = true;
    add_medium(scene, "Tube", tube, 1.5, 1.0);
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"interior-without-solid", "interior-without-solid"});
    CHECK(findings[0].text ==
          "Lid (disc) is a surface and never a solid: its ior and priority have no effect");
    CHECK(findings[1].advice == "leave out `open`, or its interior");
}

TEST_CASE("an ior under an opaque texture is found, with what to write instead", "[inspect]") {
    auto scene = seen_from_afar();
    add_opaque(scene, "Marble", geom::Sphere{});
    scene.solids[0].interior.ior = 1.5;
    scene.solids[0].interior.states_ior = true;
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"opaque-ior"});
    CHECK(findings[0].advice.find("`material { ior 1.5 }`") != std::string::npos);

    SECTION("but not where a Fresnel reflection needs it") {
        scene.textures[0].finish.reflection.fresnel = true;
        scene.textures[0].finish.reflection.max = scene::Rgb{1.0};
        CHECK(check(scene).empty());
    }
}

TEST_CASE("a camera in a medium is a note", "[inspect]") {
    auto scene = glass_over_water();
    scene.camera.location = {0.0, 0.0, 1.5};
    const auto findings = check(scene);
    CHECK(lints(findings) == Lints{"camera-inside", "camera-inside"});
    CHECK_FALSE(inspect::has_warnings(findings));
    CHECK(inspect::summary(findings) == "0 warnings, 2 notes");
}

TEST_CASE("a camera in an opaque solid is a note, whether the solid has a priority or not",
          "[inspect]") {
    auto scene = seen_from_afar();
    add_opaque(scene, "Rock", geom::Box{{-1.0, -1.0, -51.0}, {1.0, 1.0, -49.0}});
    const auto has_priority = GENERATE(false, true);
    scene.solids[0].interior.priority = 3.0;
    scene.solids[0].interior.states_priority = has_priority;
    REQUIRE(tracer::compile(scene).has_members == has_priority);
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"camera-inside-opaque"});
    CHECK(findings[0].severity == inspect::Finding::Severity::note);
    CHECK(findings[0].location.line == 1);
    CHECK(findings[0].position == scene.camera.location);
    CHECK(findings[0].text.find("Rock, which is opaque") != std::string::npos);

    SECTION("not beside it, nor in what the camera does not see") {
        scene.objects[0].no_image = true;
        CHECK(check(scene).empty());
        scene.objects[0].no_image = false;
        scene.camera.location = {0.0, 0.0, -48.9};
        CHECK(check(scene).empty());
        scene.objects[0].inverse = true;
        CHECK(lints(check(scene)) == Lints{"camera-inside-opaque"});
    }
}

TEST_CASE("a sky behind a medium that absorbs is lost, and that is said", "[inspect]") {
    auto scene = glass_over_water();
    scene.settings.outside.absorption = {0.1, 0.0, 0.2};
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"sky-absorbed"});
    CHECK(findings[0].text.find("0 in red, blue") != std::string::npos);
    CHECK(inspect::has_warnings(findings));
    scene.background.rgb = scene::Rgb{0.0};
    CHECK_FALSE(inspect::has_warnings(check(scene)));
}

TEST_CASE("a light inside an opaque solid is found, but not inside a backdrop", "[inspect]") {
    auto scene = seen_from_afar();
    add_opaque(scene, "Backdrop", geom::Sphere{{0.0, 0.0, 0.0}, 1000.0});
    add_opaque(scene, "Lamp", geom::Sphere{{5.0, 5.0, 0.0}, 1.0});
    scene.lights.push_back({.position = {5.0, 5.0, 0.0}, .location = {"test.scene", 9, 1}});
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"camera-inside-opaque", "buried-light"});
    CHECK(findings[1].location.line == 9);
    scene.objects[1].no_shadow = true;
    CHECK(lints(check(scene)) == Lints{"camera-inside-opaque"});
}

TEST_CASE("glass inside of what is opaque is found, but not what stronger solids may lay open",
          "[inspect]") {
    auto scene = seen_from_afar();
    add_opaque(scene, "Rock", geom::Box{geom::Vec3{-2.0}, geom::Vec3{2.0}});
    add_medium(scene, "Gem", geom::Sphere{geom::Vec3{0.0}, 0.5}, 2.4, 3.0);
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"buried-solid"});
    CHECK(findings[0].location.line == 2);
    CHECK(findings[0].related.at(0).location.line == 1);

    SECTION("a rock with a priority, which air of a higher one opens") {
        scene.solids[0].interior.priority = 1.0;
        scene.solids[0].interior.states_priority = true;
        add_medium(scene, "Hole", geom::Box{{-1.0, -1.0, -3.0}, {1.0, 1.0, 0.0}}, 1.0, 2.0);
        CHECK(lints(check(scene)).empty());
    }
    SECTION("a rock that mirrors do not show") {
        scene.objects[0].no_reflection = true;
        CHECK(lints(check(scene)).empty());
    }
    SECTION("a gem that sticks out") {
        scene.objects[1].transform = geom::Transform::translation({0.0, 0.0, -1.8});
        CHECK(lints(check(scene)).empty());
    }
    SECTION("the camera is in there") {
        scene.camera.location = {0.0, 0.0, -1.0};
        CHECK(lints(check(scene)) == Lints{"camera-inside-opaque"});
    }
}

TEST_CASE("a solid thinner than the tolerance is found, in any frame", "[inspect]") {
    auto scene = seen_from_afar();
    add_medium(scene, "Sheet", geom::Box{{-1.0, -1.0, 0.0}, {1.0, 1.0, 1e-4}}, 1.5, 1.0);
    scene.objects[0].transform = geom::Transform::rotation_degrees({30.0, 40.0, 50.0});
    CHECK(check(scene).empty());
    scene.settings.contact_tolerance = 1e-3;
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"thin-solid"});
    REQUIRE(findings[0].depth);
    CHECK(*findings[0].depth == Approx(1e-4));
}
