// What is grown by d reaches, from each point of the old surface, d along the normal there.

#include "povray/grow.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "geom/placed_shape.hpp"
#include "inspect/sample_lines.hpp"
#include "lang/interpret.hpp"
#include "povray/error.hpp"

using namespace meniscus;
using geom::Vec3;

namespace {

constexpr auto head = "camera { location <0, 0, -9> look_at 0 }\n";

scene::Object object(const std::string& text) {
    return lang::interpret_text("grow.scene", head + text).scene.objects.front();
}

geom::PlacedShape placed(const scene::Object& object) { return {object.shape, object.transform}; }

/// How far it is along the normals of `inner` to `outer`, at points of the inner surface, in order.
std::vector<double> reaches(const scene::Object& inner, const scene::Object& outer) {
    const auto a = placed(inner), b = placed(outer);
    const double sign = inner.inverse ? -1.0 : 1.0;
    std::vector<double> result;
    for (const auto& line : inspect::sample_lines(a.bounds(), 40)) {
        geom::Crossings crossings;
        a.crossings(line, crossings);
        for (const auto& crossing : crossings) {
            geom::Ray ray;
            ray.origin = a.on_face(crossing.face, line.at(crossing.t));
            ray.direction = sign * a.normal(crossing.face, ray.origin);
            geom::Crossings ends;
            b.crossings(ray, ends);
            double nearest = geom::infinity;
            for (const auto& end : ends)
                if (end.t > 0.0) nearest = std::min(nearest, end.t);
            result.push_back(nearest);
        }
    }
    std::ranges::sort(result);
    return result;
}

/// All points are at least the distance away, and but for few just that: in an inner corner the way
/// may lead on into the other wall's growth.
void check_reaches(const scene::Object& inner, const scene::Object& outer, double distance,
                   double margin) {
    const auto all = reaches(inner, outer);
    REQUIRE(all.size() > 30);
    CHECK(all.front() == Approx(distance).margin(margin));
    CHECK(all[all.size() * 9 / 10] == Approx(distance).margin(margin));
}

void check_reach(const std::string& text, double distance, double margin = 1e-10) {
    INFO(text << " by " << distance);
    const auto inner = object(text);
    check_reaches(inner, povray::grown(inner, distance), distance, margin);
}

}  // namespace

TEST_CASE("a shape grows by the distance along its normals", "[export][grow]") {
    const std::string shape = GENERATE(
        "sphere { <1, 2, 3>, 0.8 }", "box { <-1, 0, 1>, <0.5, 1.2, 2> }",
        "cylinder { <0, 0.1, 0>, <0.4, 1, 0.3>, 0.5 }", "torus { 1, 0.3 }",
        "cone { <0, 0, 0>, 0.7, <0.2, 1.5, 0>, 0.2 }", "cone { <0, 0, 0>, 0.2, <0, 1.5, 0>, 0.9 }",
        "lathe { linear_spline 7, <0, 0>, <0.8, 0>, <1, 2>, <0.9, 2>, <0.7, 0.2>, <0, 0.2>, <0, 0> "
        "}");
    for (const double distance : {0.01, 1e-6}) {
        check_reach(shape + "\n", distance);
        check_reach(
            shape.substr(0, shape.size() - 1) + "scale 2.5 rotate <20, 30, 40> translate x }",
            distance);
    }
}

TEST_CASE("what has shrunk grows back", "[export][grow]") {
    const std::string shape =
        GENERATE("sphere { <1, 2, 3>, 0.8 }", "box { <-1, 0, 1>, <0.5, 1.2, 2> }",
                 "cylinder { <0, 0.1, 0>, <0.4, 1, 0.3>, 0.5 }", "torus { 1, 0.3 }",
                 "cone { <0, 0, 0>, 0.7, <0.2, 1.5, 0>, 0.2 }",
                 "lathe { linear_spline 7, <0, 0>, <0.8, 0>, <1, 2>, <0.9, 2>, <0.7, 0.2>, <0, "
                 "0.2>, <0, 0> }");
    const auto whole = object(shape);
    INFO(shape);
    check_reaches(povray::grown(whole, -0.01), whole, 0.01, 1e-10);
}

TEST_CASE("a plane and a complement grow the way their normals look", "[export][grow]") {
    const auto plane = povray::grown(object("plane { y, 2 scale 3 }"), 0.25);
    CHECK(placed(plane).contains({0, 6.2499, 0}));
    CHECK_FALSE(placed(plane).contains({0, 6.2501, 0}));
    const auto inverse = povray::grown(object("sphere { 0, 1 inverse }"), 0.25);
    CHECK(std::get<geom::Sphere>(inverse.shape).radius == Approx(0.75));
}

TEST_CASE("boxes grow by the distance under any map", "[export][grow]") {
    check_reach("box { -1, 1 scale <2, 0.5, 1> }", 0.01);
    check_reach("box { -1, 1 matrix <1, 0, 0, 0.4, 1, 0, 0, 0.3, 1, 0, 1, 0> }", 0.01);
}

TEST_CASE("under a stretch the distance is divided by each axis' scale", "[export][grow]") {
    const auto outer = povray::grown(object("sphere { 0, 1 scale <3, 1, 0.5> }"), 0.01);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 tip{0.0};
        tip[axis] = Vec3{3, 1, 0.5}[axis];
        Vec3 more{0.0};
        more[axis] = 0.01;
        CHECK(placed(outer).contains(tip + 0.999 * more));
        CHECK_FALSE(placed(outer).contains(tip + 1.001 * more));
    }
    // Turned on its axis after a stretch along it, a lathe's profile takes the stretch in.
    check_reach("lathe { linear_spline 4, <0, 0>, <0.8, 0.1>, <0.6, 1>, <0, 1.1> scale <1, 3, 1> }",
                0.01);
}

TEST_CASE("a curved profile grows by the distance, to a hundredth of it", "[export][grow]") {
    const std::string vase =
        "lathe { bezier_spline 8, <0, 0> <0.5, 0> <0.9, 0.4> <0.8, 1> <0.8, 1> <0.7, 1.6> <0.3, "
        "1.8> <0, 1.8> }";
    for (const double distance : {1e-2, 1e-4, 1e-6}) check_reach(vase, distance, 0.01 * distance);
}

TEST_CASE("a mesh's vertices move along the mean of their faces' normals", "[export][grow]") {
    // Of a regular octahedron that mean leads outwards from the centre, the angles being alike; and
    // all faces move by the distance: the vertices by sqrt(3) times as much.
    const auto octahedron = object(
        "mesh2 { vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, "
        "0, -1> }"
        "face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>, <2, 0, 5>, <1, 2, 5>, <3, "
        "1, 5>, <0, 3, 5> } }");
    const auto outer = povray::grown(octahedron, 0.01);
    const auto& mesh = *std::get<geom::Mesh>(outer.shape).triangles;
    for (geom::Face face = 0; face < geom::Face(mesh.size()); ++face) {
        for (const auto& p : mesh.corners(face))
            CHECK(glm::length(p) == Approx(1.0 + 0.01 * std::sqrt(3.0)).epsilon(1e-12));
    }
    check_reaches(octahedron, outer, 0.01, 1e-11);
}

TEST_CASE("a smooth mesh that grows is shaded with the same normals", "[export][grow]") {
    // Of a regular octahedron they look away from the centre, wherever its corners are; mirrored
    // and stretched, the inverse of the stretch has them.
    const std::string octahedron =
        "mesh2 { vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, "
        "0, -1> } normal_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, "
        "0, -1> }"
        "face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>, <2, 0, 5>, <1, 2, 5>, <3, "
        "1, 5>, <0, 3, 5> } ";
    for (const std::string map : {"", "scale <-1, 1, 1>", "scale <1, 2, 1>"}) {
        CAPTURE(map);
        const auto outer = povray::grown(object(octahedron + map + " }"), 0.01);
        const auto& mesh = *std::get<geom::Mesh>(outer.shape).triangles;
        for (geom::Face face = 0; face < geom::Face(mesh.size()); ++face) {
            for (const auto& p : mesh.corners(face)) {
                const auto normal = mesh.shading_normal(face, p);
                CHECK(glm::length(normal - glm::normalize(p)) < 1e-12);
            }
        }
    }
}

TEST_CASE("the angles weigh: a face cut in two counts once", "[export][grow]") {
    // A cube whose faces are two triangles each: corners touch three faces by one triangle or by
    // two, at the same angle in all.
    const auto cube = object(
        "mesh2 { vertex_vectors { 8, <0,0,0>, <1,0,0>, <1,1,0>, <0,1,0>, <0,0,1>, <1,0,1>, "
        "<1,1,1>, <0,1,1> }"
        "face_indices { 12, <0,2,1>, <0,3,2>, <4,5,6>, <4,6,7>, <0,1,5>, <0,5,4>, <3,7,6>, "
        "<3,6,2>, <0,4,7>, "
        "<0,7,3>, <1,2,6>, <1,6,5> } }");
    const auto outer = povray::grown(cube, 0.1);
    const auto& mesh = *std::get<geom::Mesh>(outer.shape).triangles;
    for (geom::Face face = 0; face < geom::Face(mesh.size()); ++face) {
        for (const auto& p : mesh.corners(face)) {
            for (int i = 0; i < 3; ++i) CHECK(std::abs(p[i] - 0.5) == Approx(0.6).epsilon(1e-12));
        }
    }
}

TEST_CASE("what would not be sound is refused at its line", "[export][grow]") {
    const auto [text, distance, why] = GENERATE(table<std::string, double, std::string>({
        {"sphere { 0, 0.1 }", -0.2, "smaller than what is taken"},
        {"box { 0, <1, 1, 0.1> }", -0.06, "smaller than what is taken"},
        // Two tetrahedra 0.1 apart in one mesh.
        {"mesh2 { vertex_vectors { 8, <0,0,0>, <1,0,0>, <0,1,0>, <0,0,1>, <-0.1,-0.1,-0.1>, "
         "<-1,0,0>, <0,-1,0>, <0,0,-1> }"
         "face_indices { 8, <0,2,1>, <0,1,3>, <0,3,2>, <1,2,3>, <4,5,6>, <4,7,5>, <4,6,7>, <5,7,6> "
         "} }",
         0.2, "pass through itself"},
    }));
    INFO(text);
    try {
        povray::grown(object(text), distance);
        FAIL("not refused");
    } catch (const povray::ExportError& error) {
        CHECK_THAT(error.what(), Catch::Contains(why));
        CHECK(error.location.line == 2);
        CHECK(error.location.column == 1);
    }
}
