#include "inspect/check.hpp"

#include <catch2/catch.hpp>

#include "tests/inspect/scenes.hpp"

using namespace meniscus;
using namespace meniscus::test;
using inspect::Finding;

namespace {

std::vector<Finding> check(const scene::Scene& scene) {
    return inspect::check(tracer::compile(scene));
}

scene::Scene seen_from_afar() {
    scene::Scene scene;
    scene.camera.location = {0.0, 0.0, -50.0};
    return scene;
}

/// The names of the rules that found something.
std::vector<std::string> lints(const std::vector<Finding>& findings) {
    std::vector<std::string> names;
    for (const auto& finding : findings) names.push_back(finding.lint);
    return names;
}

using Lints = std::vector<std::string>;

}  // namespace

TEST_CASE("a healthy scene has no findings", "[inspect]") {
    auto scene = glass_over_water();
    add_opaque(scene, "Floor", geom::Plane{{0.0, 1.0, 0.0}, -20.0});
    scene.lights.push_back({.position = {10.0, 10.0, -10.0}, .location = {}});
    CHECK(check(scene).empty());
}

TEST_CASE("unlike media of equal priority that overlap are found, with a point in both",
          "[inspect]") {
    auto scene = seen_from_afar();
    const geom::Sphere a{{0.0, 0.0, 0.0}, 1.0}, b{{1.1, 1.0, 1.2}, 1.0};
    add_medium(scene, "Glass", a, 1.5, 3.0);
    add_medium(scene, "Water", b, 1.33, 3.0);
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"equal-priority-overlap"});
    CHECK(findings[0].location.line == 2);
    CHECK(findings[0].related.at(0).location.line == 1);
    REQUIRE(findings[0].position);
    CHECK(a.contains(*findings[0].position));
    CHECK(b.contains(*findings[0].position));
    REQUIRE(findings[0].depth);
    CHECK(*findings[0].depth > 0.0);
    CHECK(*findings[0].depth <= 2.0 - std::sqrt(1.1 * 1.1 + 1.0 + 1.2 * 1.2) + 1e-9);
    CHECK(findings[0].advice == "give the one that is there a higher priority, as `priority 4`");
    CHECK(inspect::has_warnings(findings));

    SECTION("not where priorities differ") {
        scene.solids[0].interior.priority = 4.0;
        CHECK(check(scene).empty());
    }
    SECTION("not where the media are alike") {
        scene.solids[0].interior.ior = 1.33;
        CHECK(check(scene).empty());
    }
    SECTION("nor between members of one union") {
        scene.objects[1].solid = 0;
        CHECK(check(scene).empty());
    }
}

TEST_CASE("solids that touch do not overlap", "[inspect]") {
    auto scene = seen_from_afar();
    add_medium(scene, "Left", geom::Box{{-1.0, 0.0, 0.0}, {0.1, 1.0, 1.0}}, 1.5, 0.0);
    add_medium(scene, "Right", geom::Box{{0.1, 0.0, 0.0}, {1.0, 1.0, 1.0}}, 1.4, 0.0);
    add_medium(scene, "Ball", geom::Sphere{{0.5, 1.7, 0.5}, 0.7}, 1.3, 0.0);
    add_medium(scene, "Core", geom::Cylinder{{3.0, 0.0, 0.0}, {3.0, 1.0, 0.0}, 0.3}, 1.3, 0.0);
    auto& inverse =
        add_medium(scene, "Around", geom::Cylinder{{3.0, 0.0, 0.0}, {3.0, 1.0, 0.0}, 0.3}, 1.3, 0);
    inverse.inverse = true;
    // All is inside `Around` but what is in `Core`.
    for (const auto& finding : check(scene)) {
        INFO(finding.text);
        if (finding.lint == "camera-inside") continue;
        CHECK(finding.related.at(0).location.line != 4);
        CHECK(finding.location.line == 5);
    }
}

TEST_CASE("a half-space overlaps too", "[inspect]") {
    auto scene = seen_from_afar();
    add_medium(scene, "Ocean", geom::Plane{{0.0, 1.0, 0.0}, 0.0}, 1.33, 0.0);
    add_medium(scene, "Bottle", geom::Box{{0.0, -0.01, 0.0}, {1.0, 2.0, 1.0}}, 1.5, 0.0);
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"equal-priority-overlap"});
    CHECK(findings[0].position->y < 0.0);
    CHECK(findings[0].position->y > -0.01);
}

TEST_CASE("many overlaps from one place in the text are one finding", "[inspect]") {
    auto scene = seen_from_afar();
    add_medium(scene, "Water", geom::Box{{-1.0, -1.0, -1.0}, {9.0, 1.0, 1.0}}, 1.33, 0.0);
    for (int i = 0; i < 4; ++i) {
        auto& bubble =
            add_medium(scene, "Bubble", geom::Sphere{{2.0 * i, 0.0, 0.0}, 0.1}, 1.0, 0.0);
        bubble.location.line = 7;
    }
    const auto findings = check(scene);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].text.find("(and 3 more from here)") != std::string::npos);
}

TEST_CASE("gaps too thin to be meant are found, wider ones and contact are not", "[inspect]") {
    const auto with_gap = [](double gap, double contact_tolerance = 0.0) {
        auto scene = seen_from_afar();
        if (contact_tolerance > 0.0) scene.settings.contact_tolerance = contact_tolerance;
        add_medium(scene, "Glass", geom::Box{{-1.0, 0.0, -1.0}, {1.0, 1.0, 1.0}}, 1.5, 2.0);
        add_medium(scene, "Water", geom::Box{{-1.0, 1.0 + gap, -1.0}, {1.0, 2.0, 1.0}}, 1.33, 1.0);
        return lints(check(scene));
    };
    CHECK(with_gap(1e-9) == Lints{"thin-gap"});
    CHECK(with_gap(1e-9, 1e-8).empty());
    CHECK(with_gap(0.0).empty());
    CHECK(with_gap(1e-4).empty());
    CHECK(with_gap(-1e-9).empty());
    CHECK(with_gap(5e-14) == Lints{"thin-gap"});  // between tau and 100 tau
}

TEST_CASE("an overlap of a billionth is an overlap where priorities are equal", "[inspect]") {
    auto scene = seen_from_afar();
    add_medium(scene, "Left", geom::Box{{-1.0, 0.0, 0.0}, {1e-9, 1.0, 1.0}}, 1.5, 0.0);
    add_medium(scene, "Right", geom::Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, 1.4, 0.0);
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"equal-priority-overlap"});
    CHECK(*findings[0].depth == Approx(1e-9).epsilon(1e-6));
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

TEST_CASE("an overlap that a stronger solid covers is none", "[inspect]") {
    const auto with_wall = [](double half) {
        auto scene = seen_from_afar();
        add_medium(scene, "Left", geom::Box{{-1.0, -1.0, -1.0}, {0.05, 1.0, 1.0}}, 1.33, 1.0);
        add_medium(scene, "Right", geom::Box{{-0.05, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1.47, 1.0);
        add_medium(scene, "Wall", geom::Box{{-half, -1.1, -1.1}, {half, 1.1, 1.1}}, 1.5, 2.0);
        return lints(check(scene));
    };
    CHECK(with_wall(0.1).empty());
    CHECK(with_wall(0.05).empty());
    CHECK(with_wall(0.04) == Lints{"equal-priority-overlap"});
}

TEST_CASE("a solid that sticks out of one of higher priority by a trifle is a film", "[inspect]") {
    const auto with_film = [](double film) {
        auto scene = seen_from_afar();
        const Vec3 up{0.0, 1.0, 0.0};
        add_medium(scene, "Glass", geom::Cylinder{-up, up, 1.0}, 1.5, 2.0);
        add_medium(scene, "Water", geom::Cylinder{-0.5 * up, 2.0 * up, 1.0 + film}, 1.33, 1.0);
        return check(scene);
    };
    const auto findings = with_film(1e-9);
    REQUIRE(lints(findings) == Lints{"thin-film"});
    CHECK(findings[0].location.line == 2);
    CHECK(*findings[0].depth == Approx(1e-9).epsilon(1e-5));
    CHECK(std::hypot(findings[0].position->x, findings[0].position->z) == Approx(1.0));
    SECTION("but not where a third solid covers it") {
        auto scene = seen_from_afar();
        const Vec3 up{0.0, 1.0, 0.0};
        add_medium(scene, "Glass", geom::Cylinder{-up, up, 1.0}, 1.5, 2.0);
        add_medium(scene, "Water", geom::Cylinder{-2.0 * up, 2.0 * up, 1.0 + 1e-9}, 1.33, 1.0);
        add_medium(scene, "Ice", geom::Box{Vec3{-3.0}, Vec3{3.0}}, 1.31, 1.5);
        CHECK(lints(check(scene)) == Lints{"hidden-solid"});
    }
    CHECK(with_film(0.0).empty());
    CHECK(with_film(-1e-9).empty());  // the glass is outside then, all along
    CHECK(with_film(1e-3).empty());
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
    CHECK(findings[0].severity == Finding::Severity::note);
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
