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
    REQUIRE(lints(findings) == Lints{"buried-light"});
    CHECK(findings[0].location.line == 9);
    scene.objects[1].no_shadow = true;
    CHECK(check(scene).empty());
}
