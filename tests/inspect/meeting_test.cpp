#include <catch2/catch.hpp>
#include <cmath>

#include "tests/inspect/checked.hpp"

using namespace meniscus;
using namespace meniscus::test;

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

TEST_CASE("gaps between parts of one union are found, but where another part fills them",
          "[inspect]") {
    const auto with_gap = [](double gap, double contact_tolerance = 0.0) {
        auto scene = seen_from_afar();
        if (contact_tolerance > 0.0) scene.settings.contact_tolerance = contact_tolerance;
        add_medium(scene, "Low", geom::Box{{-1.0, 0.0, -1.0}, {1.0, 1.0, 1.0}}, 1.5, 2.0);
        add_medium(scene, "High", geom::Box{{-1.0, 1.0 + gap, -1.0}, {1.0, 2.0, 1.0}}, 1.5, 2.0);
        scene.objects[1].solid = 0;
        return scene;
    };
    const auto findings = check(with_gap(1e-9));
    REQUIRE(lints(findings) == Lints{"thin-gap"});
    REQUIRE(findings[0].depth);
    CHECK(*findings[0].depth == Approx(1e-9));
    CHECK(check(with_gap(0.0)).empty());
    CHECK(check(with_gap(1e-4)).empty());
    CHECK(check(with_gap(1e-9, 1e-8)).empty());
    auto filled = with_gap(1e-9);
    add_medium(filled, "Core", geom::Box{{-1.0, 0.5, -1.0}, {1.0, 1.5, 1.0}}, 1.5, 2.0);
    filled.objects[2].solid = 0;
    CHECK(check(filled).empty());
    SECTION("nor between a part and another solid") {
        auto scene = with_gap(-0.5);
        add_medium(scene, "Water", geom::Box{{-1.0, 1.0 + 1e-9, -1.0}, {1.0, 2.0, 1.0}}, 1.3, 1.0);
        CHECK(lints(check(scene)) == Lints{"hidden-solid"});
    }
}

TEST_CASE("an overlap of a billionth is an overlap where priorities are equal", "[inspect]") {
    auto scene = seen_from_afar();
    add_medium(scene, "Left", geom::Box{{-1.0, 0.0, 0.0}, {1e-9, 1.0, 1.0}}, 1.5, 0.0);
    add_medium(scene, "Right", geom::Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, 1.4, 0.0);
    const auto findings = check(scene);
    REQUIRE(lints(findings) == Lints{"equal-priority-overlap"});
    CHECK(*findings[0].depth == Approx(1e-9).epsilon(1e-6));
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
