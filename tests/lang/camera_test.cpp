#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

scene::Camera camera(const std::string& text) {
    return interpret("#version 3.7; camera { " + text + " }").scene.camera;
}

bool near(const geom::Vec3& a, const geom::Vec3& b) { return glm::length(a - b) < 1e-12; }

}  // namespace

TEST_CASE("a camera without a word is POV-Ray's default", "[lang]") {
    const auto c = camera("");
    CHECK(c.location == geom::Vec3{0.0});
    CHECK(c.direction == geom::Vec3{0, 0, 1});
    CHECK(c.right == geom::Vec3{1.33, 0, 0});
    CHECK(c.up == geom::Vec3{0, 1, 0});
}

TEST_CASE("look_at turns the camera and keeps its lengths", "[lang]") {
    const auto c = camera("location <0, 0, -5> look_at <0, 5, 0> right 2*x");
    CHECK(near(c.direction, glm::normalize(geom::Vec3{0, 1, 1})));
    CHECK(near(c.right, {2, 0, 0}));
    CHECK(near(c.up, glm::normalize(geom::Vec3{0, 1, -1})));
    CHECK(near(camera("location -z look_at 0 right -x").right, {-1, 0, 0}));
    CHECK(near(camera("location 18*y look_at 0 right x").up, {0, 0, 1}));
}

TEST_CASE("angle is the horizontal one", "[lang]") {
    const auto c = camera("location -z look_at 0 right 2*x angle 90");
    CHECK(near(c.direction, {0, 0, 1}));
}

TEST_CASE("an orthographic camera is sized by the rules of POV-Ray", "[lang]") {
    CHECK(camera("orthographic location -5*z").right.x == Approx(1.33 * 6));
    CHECK(camera("orthographic location -5*z look_at 0").right.x == Approx(1.33 * 5));
    CHECK(camera("orthographic location -5*z look_at 0 right 2*x up 2*y").right.x == Approx(2));
    CHECK(camera("orthographic location -5*z angle 90").right.x == Approx(12));
    CHECK(camera("orthographic location -5*z direction 2*z").right.x == Approx(1.33 * 3));
}

TEST_CASE("a camera's transformations come last", "[lang]") {
    const auto c = camera("location -5*z look_at 0 rotate 90*y translate y");
    CHECK(near(c.location, {-5, 1, 0}));
    CHECK(near(c.direction, {1, 0, 0}));
}

TEST_CASE("other cameras are refused", "[lang]") {
    CHECK(error("camera { fisheye angle 180 }") ==
          "this is POV-Ray, but not supported here: `fisheye`");
    CHECK(error("#declare C = camera { fisheye }") == "");
}

}  // namespace meniscus::lang::test
