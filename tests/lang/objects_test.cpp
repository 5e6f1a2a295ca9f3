#include <catch2/catch.hpp>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

scene::Scene read(const std::string& text) {
    return interpret("#version 3.7; global_settings { assumed_gamma 1 }\n" + text).scene;
}

template <class Shape>
Shape shape(const std::string& text) {
    return std::get<Shape>(read(text).objects.at(0).shape);
}

bool near(const geom::Vec3& a, const geom::Vec3& b) { return glm::length(a - b) < 1e-12; }

}  // namespace

TEST_CASE("primitives take their arguments in order", "[lang]") {
    CHECK(shape<geom::Sphere>("sphere { <1,2,3>, 4 }").center == geom::Vec3{1, 2, 3});
    CHECK(shape<geom::Sphere>("sphere { 0 2 }").radius == 2.0);
    CHECK(shape<geom::Box>("box{-1 1}").corner2 == geom::Vec3{1.0});
    const auto cylinder = shape<geom::Cylinder>("cylinder { 0, y, 0.5 open }");
    CHECK(cylinder.open);
    CHECK(cylinder.radius == 0.5);
    CHECK(shape<geom::Cone>("cone{0 1 y 0}").base_radius == 1.0);
    CHECK(shape<geom::Torus>("torus { 2, 0.5 sturm }").minor == 0.5);
    CHECK(shape<geom::Plane>("plane { y, -1 }").distance == -1.0);
    CHECK(shape<geom::Disc>("disc { 0, y, 2 }").hole_radius == 0.0);
    CHECK(shape<geom::Disc>("disc { 0, y, 2, 1 }").hole_radius == 1.0);
    CHECK(shape<geom::Triangle>("triangle { 0, x, y }").b == geom::Vec3{1, 0, 0});
    CHECK(shape<geom::Triangle>("smooth_triangle { 0, z, x, z, y, z }").smooth);
    CHECK(shape<geom::Polygon>("polygon { 5, 0, x, x+y, y, 0 }").points().size() == 5);
    CHECK(shape<geom::Lathe>("lathe { linear_spline 5, <1,0>, <2,0>, <2,1>, <1,1>, <1,0> }")
              .points()
              .size() == 5);
}

TEST_CASE("transformations apply in the order written, textures included", "[lang]") {
    const auto scene =
        read("sphere { 0, 1 translate x rotate 90*z pigment { checker } translate y }");
    CHECK(near(scene.objects[0].transform.point({0, 0, 0}), {0, 2, 0}));
    CHECK(near(scene.textures[0].transform.point({0, 0, 0}), {0, 1, 0}));
    CHECK(
        near(read("sphere { 0, 1 rotate 90*y translate x }").objects[0].transform.point({0, 0, 1}),
             {2, 0, 0}));
    CHECK(
        near(read("#declare T = transform { translate x } sphere { 0, 1 transform { T scale 2 } }")
                 .objects[0]
                 .transform.point({0, 0, 0}),
             {2, 0, 0}));
    CHECK(near(read("sphere { 0, 1 matrix <1,0,0, 0,1,0, 0,0,1, 5,6,7> }")
                   .objects[0]
                   .transform.point({0, 0, 0}),
               {5, 6, 7}));
    CHECK(interpret("#version 3.7; sphere { 0, 1 scale <1,0,1> }").warnings.size() == 1);
}

TEST_CASE("a union that states an interior is one solid", "[lang]") {
    const auto shared = read("union { sphere { 0, 1 } sphere { x, 1 } interior { ior 1.5 } }");
    CHECK(shared.solids.size() == 1);
    CHECK(shared.objects[0].solid == shared.objects[1].solid);
    const auto inner = read(
        "union { sphere { 0, 1 interior { ior 1.3 } } union { box { 0, 1 } box { 2, 3 } interior { "
        "ior 1.2 } } interior { ior 1.5 } }");
    CHECK(inner.solids.size() == 3);
    CHECK(inner.solids[inner.objects[0].solid].interior.ior == 1.3);
    CHECK(inner.objects[1].solid == inner.objects[2].solid);
    CHECK(inner.solids[inner.objects[2].solid].interior.ior == 1.2);
    const auto none = read("union { union { sphere { 0, 1 } } box { 0, 1 } }");
    CHECK(none.objects[0].solid == none.objects[1].solid);
}

TEST_CASE("objects that share a declared interior are solids of their own", "[lang]") {
    const auto scene = read(
        "#declare I = interior { ior 1.5 } sphere { 0, 1 interior { I } } sphere { x, 1 interior { "
        "I } }");
    CHECK(scene.objects[0].solid != scene.objects[1].solid);
}

TEST_CASE("a child's texture wins over its union's, which moves with the union", "[lang]") {
    const auto scene = read(
        "union { sphere { 0, 1 pigment { rgb x } translate x } sphere { 0, 1 } pigment { rgb y } "
        "translate 2*y }");
    const auto color = [&](std::size_t i) {
        return std::get<scene::SolidColor>(scene.textures[scene.objects[i].texture].pigment.pattern)
            .color.rgb;
    };
    CHECK(color(0) == scene::Rgb{1, 0, 0});
    CHECK(color(1) == scene::Rgb{0, 1, 0});
    CHECK(near(scene.textures[scene.objects[0].texture].transform.point({0, 0, 0}), {1, 2, 0}));
    CHECK(near(scene.textures[scene.objects[1].texture].transform.point({0, 0, 0}), {0, 2, 0}));
}

TEST_CASE("objects are called by their declaration", "[lang]") {
    const auto scene = read(
        "#declare Glass = sphere { 0, 1 interior { ior 1.5 } }\nobject { Glass }\nbox { 0, 1 }");
    CHECK(scene.solids[0].name == "Glass");
    CHECK(scene.objects[0].name == "Glass");
    CHECK(scene.objects[0].location.line == 3);
    CHECK(scene.objects[1].name == "box");
    CHECK(scene.objects[1].location.line == 4);
}

TEST_CASE("flags", "[lang]") {
    const auto o = read(
                       "union { sphere { 0, 1 inverse } box { 0, 1 no_image } no_shadow hollow on "
                       "double_illuminate no_reflection }")
                       .objects;
    CHECK(o[0].inverse);
    CHECK_FALSE(o[1].inverse);
    CHECK(o[1].no_image);
    CHECK_FALSE(o[0].no_image);
    CHECK((o[0].no_shadow && o[1].no_shadow && o[0].hollow && o[0].double_illuminate &&
           o[0].no_reflection));
}

TEST_CASE("meshes", "[lang]") {
    const auto mesh = shape<geom::Mesh>(
        "mesh { triangle { 0, x, y } smooth_triangle { 0, z, x, z, y, z } inside_vector y }");
    CHECK(mesh.triangles->stats().triangles >= 1);
    const auto mesh2 = shape<geom::Mesh>(
        "mesh2 { vertex_vectors { 4, 0, x, y, z } normal_vectors { 4, -x, x, y, z }"
        " face_indices { 4, <0,1,2>, <0,1,3>, <0,2,3>, <1,2,3> } }");
    CHECK(mesh2.is_closed());
}

TEST_CASE("lights", "[lang]") {
    const auto light = read(
                           "light_source { <1,2,3>, rgb <1,0.5,0> spotlight point_at y radius 10 "
                           "falloff 20 tightness 5 fade_distance 3 fade_power 2 translate x }")
                           .lights.at(0);
    CHECK(light.kind == scene::Light::Kind::spot);
    CHECK(light.position == geom::Vec3{2, 2, 3});
    CHECK(light.point_at == geom::Vec3{1, 1, 0});
    CHECK(light.falloff == 20.0);
    CHECK(light.fade_power == 2.0);
    CHECK(read("light_source { 0, 1 cylinder }").lights[0].radius == 0.75);
    CHECK(read("light_source { 0, 1 parallel shadowless }").lights[0].shadowless);
    CHECK(read("union { light_source { x, 1 } sphere { 0, 1 } translate y }").lights[0].position ==
          geom::Vec3{1, 1, 0});
    CHECK(interpret("#version 3.7; light_source { 0, 1 area_light x, y, 3, 3 adaptive 1 jitter }")
              .warnings.size() == 1);
}

TEST_CASE("what a light looks like moves with it and throws no shadow", "[lang]") {
    const auto scene = read(
        "light_source { <1,2,3>, 1 translate x looks_like { sphere { 0, 0.1 } } translate y }");
    REQUIRE(scene.objects.size() == 1);
    CHECK(scene.objects[0].no_shadow);
    CHECK(near(scene.objects[0].transform.point({0, 0, 0}), {2, 3, 3}));
}

TEST_CASE("what is not supported may be declared, but not used", "[lang]") {
    const std::string declared =
        "#declare D = difference { sphere { 0, 1 } box { 0, 1 } } #declare T = texture { pigment { "
        "granite turbulence 1 } }";
    CHECK(error(declared) == "");
    CHECK(error(declared + "object { D }") ==
          "this is POV-Ray, but not supported here: `difference`");
    CHECK(error(declared + "sphere { 0, 1 texture { T } }") ==
          "this is POV-Ray, but not supported here: `granite`");
    CHECK(printed_error("intersection { }").find("inverse") != std::string::npos);
    CHECK(error("#declare F = function { x*y }; #declare A = F(1,2);") == "");
    CHECK(error("#declare F = function { x*y } sphere { F(1,2), 1 }") ==
          "this is POV-Ray, but not supported here: `function`");
    CHECK(error("sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } } }") ==
          "this is POV-Ray, but not supported here: `layered textures`");
    CHECK(error("sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgb x } } }") ==
          "");
}

}  // namespace meniscus::lang::test
