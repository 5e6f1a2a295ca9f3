#include <algorithm>
#include <catch2/catch.hpp>

#include "geom/placed_shape.hpp"
#include "lang/interpret.hpp"
#include "povray/film.hpp"

using namespace meniscus;
using geom::Vec3;

namespace {

scene::Scene read(const std::string& text) {
    return lang::interpret_text("films.scene", "camera { location <0, 0, -9> look_at 0 }\n" + text)
        .scene;
}

/// The ior of the highest solid that contains the point; 1 outside of all.
double ior_at(const scene::Scene& scene, const Vec3& point) {
    const scene::Interior* top = &scene.settings.outside;
    double priority = -geom::infinity;
    for (const auto& object : scene.objects) {
        const auto& interior = scene.solids[object.solid].interior;
        if (!interior.states_ior || interior.priority <= priority) continue;
        if (!geom::PlacedShape(object.shape, object.transform).contains(point)) continue;
        top = &interior;
        priority = interior.priority;
    }
    return top->ior;
}

}  // namespace

TEST_CASE("a film of the outside's medium lies round what cuts another solid", "[export][film]") {
    const auto filmed =
        povray::with_films(read("sphere { 0, 1 material { ior 1.5 priority 1 } }\n"
                                "sphere { 0, 0.8 material { ior 1.33 priority 2 } }"),
                           0.01);
    REQUIRE(filmed.thickness);
    CHECK(filmed.thickness->least == Approx(0.01).epsilon(1e-9));
    CHECK(filmed.thickness->largest == Approx(0.01).epsilon(1e-9));
    CHECK(ior_at(filmed.scene, {0.7999, 0, 0}) == 1.33);
    CHECK(ior_at(filmed.scene, {0.8001, 0, 0}) == 1.0);
    CHECK(ior_at(filmed.scene, {0.8099, 0, 0}) == 1.0);
    CHECK(ior_at(filmed.scene, {0.8101, 0, 0}) == 1.5);
    CHECK(ior_at(filmed.scene, {0.9999, 0, 0}) == 1.5);
    CHECK(ior_at(filmed.scene, {1.0001, 0, 0}) == 1.0);
}

TEST_CASE("of three in one place the middle one has films on both sides", "[export][film]") {
    const auto filmed =
        povray::with_films(read("sphere { 0, 1 material { ior 1.5 priority 1 } }\n"
                                "sphere { 0, 0.8 material { ior 1.33 priority 2 } }\n"
                                "sphere { 0, 0.5 material { ior 1.31 priority 3 } }"),
                           0.01);
    for (const auto& [radius, ior] :
         {std::pair{0.49, 1.31}, {0.505, 1.0}, {0.52, 1.33}, {0.805, 1.0}, {0.82, 1.5}})
        CHECK(ior_at(filmed.scene, {0, radius, 0}) == ior);
}

TEST_CASE("what is hidden in a higher solid stays so beside films", "[export][film]") {
    const auto filmed =
        povray::with_films(read("sphere { 0, 1 material { ior 1.5 priority 7 } }\n"
                                "sphere { 0, 0.8 material { ior 1.33 priority 6 } }\n"
                                "sphere { 2*y, 1.2 material { ior 1.4 priority 8 } }"),
                           0.01);
    for (const auto& [y, ior] : {std::pair{-0.81, 1.5},
                                 {-0.79, 1.5},
                                 {0.78, 1.5},
                                 {0.785, 1.5},
                                 {0.795, 1.0},
                                 {0.81, 1.4}})
        CHECK(ior_at(filmed.scene, {0, y, 0}) == ior);
    const auto& solids = filmed.scene.solids;
    const auto hidden =
        std::ranges::find_if(solids, [](const auto& s) { return s.interior.ior == 1.33; });
    for (auto solid = solids.begin(); solid != solids.end(); ++solid)
        CHECK((solid == hidden || solid->interior.priority > hidden->interior.priority));
}

TEST_CASE("the outside's medium needs no film, and one alone has none", "[export][film]") {
    CHECK_FALSE(povray::with_films(read("sphere { 0, 1 material { ior 1.5 } }"), 0.01).thickness);
    const auto bubble = povray::with_films(read("sphere { 0, 1 material { ior 1.5 priority 1 } }\n"
                                                "sphere { 0, 0.8 material { ior 1 priority 2 } }"),
                                           0.01);
    CHECK_FALSE(bubble.thickness);
    CHECK(bubble.scene.objects.size() == 2);
}

TEST_CASE("an opaque surface that glass stands on gets a film", "[export][film]") {
    const auto filmed =
        povray::with_films(read("plane { y, 0 pigment { rgb 1 } }\n"
                                "box { <-1, 0, -1>, 1 material { ior 1.5 priority 1 } }"),
                           0.01);
    CHECK(ior_at(filmed.scene, {0, 0.005, 0}) == 1.0);
    CHECK(ior_at(filmed.scene, {0, 0.015, 0}) == 1.5);
}

TEST_CASE("a stretched film's least and largest thickness are told", "[export][film]") {
    // An ellipsoid of axes a + d lies within the surface at a distance of d from the one of axes a,
    // and touches it at the tips: sqrt(sum (a + d)^2 n^2) <= sqrt(sum a^2 n^2) + d.
    const auto filmed = povray::with_films(
        read("sphere { 0, 3 material { ior 1.5 priority 1 } }\n"
             "sphere { 0, 1 scale <2, 1, 0.5> material { ior 1.33 priority 2 } }"),
        0.01);
    REQUIRE(filmed.thickness);
    CHECK(filmed.thickness->largest == Approx(0.01).epsilon(1e-3));
    CHECK(filmed.thickness->largest <= 0.01 * (1.0 + 1e-9));
    CHECK(filmed.thickness->least < 0.0099);
    CHECK(filmed.thickness->least > 0.005);
}

TEST_CASE("a film in a corner is as thick as the way to its edge", "[export][film]") {
    // Within a cup the film's wall and bottom stand before the glass's by the gap each and meet in
    // an edge: from the corner behind that it is sqrt(2) gaps away, from all else nearer. Straight
    // up from beside the corner it would be the height of the cup.
    const double gap = GENERATE(0.003, 0.03, 0.1);
    const auto filmed = povray::with_films(
        read("lathe { linear_spline 7, <0, 0> <1, 0> <1, 2> <0.9, 2> <0.9, 0.15> <0, 0.15> <0, 0>\n"
             "    material { ior 1.5 priority 2 } }\n"
             "cylinder { 0.15*y, 1.4*y, 0.9 material { ior 1.33 priority 1 } }"),
        gap);
    REQUIRE(filmed.thickness);
    CHECK(filmed.thickness->least == Approx(gap).epsilon(1e-9));
    CHECK(filmed.thickness->largest <= gap * std::sqrt(2.0) * (1.0 + 1e-4));
    if (gap == 0.1) CHECK(filmed.thickness->largest > 1.3 * gap);  // some lines end in the corner
}
