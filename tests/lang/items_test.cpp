#include <catch2/catch.hpp>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

scene::Scene read(const std::string& text) {
    return interpret("#version 3.7; global_settings { assumed_gamma 1 }\n" + text).scene;
}

scene::Texture texture(const std::string& text) {
    return read("sphere { 0, 1 " + text + " }").textures.at(0);
}
scene::Pigment pigment(const std::string& text) {
    return texture("pigment { " + text + " }").pigment;
}
scene::Finish finish(const std::string& text) { return texture("finish { " + text + " }").finish; }
scene::Interior interior(const std::string& text) {
    return read("sphere { 0, 1 " + text + " }").solids.at(0).interior;
}

scene::Color solid(const std::string& text) {
    return std::get<scene::SolidColor>(pigment(text).pattern).color;
}

}  // namespace

TEST_CASE("solid colors", "[lang]") {
    CHECK(solid("rgb <1, 0.5, 0>") == scene::Color{{1, 0.5, 0}, 0, 0});
    CHECK(solid("color rgbt 1") == scene::Color{{1, 1, 1}, 0, 1});
    CHECK(solid("rgbf <1, 1, 1, 0.9>") == scene::Color{{1, 1, 1}, 0.9, 0});
    CHECK(solid("red 1 transmit 0.25") == scene::Color{{1, 0, 0}, 0, 0.25});
    CHECK(std::get<scene::SolidColor>(
              read("#declare C = rgb x; sphere { 0, 1 pigment { C } }").textures[0].pigment.pattern)
              .color.rgb.r == 1.0);
}

TEST_CASE("patterns of lists and maps", "[lang]") {
    const auto checker = pigment("checker rgb 1, rgb <1,0,0> scale 2");
    const auto& list = std::get<scene::Checker>(checker.pattern);
    CHECK(std::get<scene::SolidColor>(list.second->pattern).color.rgb == scene::Rgb{1, 0, 0});
    CHECK(checker.transform.linear()[0].x == 2.0);
    CHECK(std::holds_alternative<scene::Hexagon>(pigment("hexagon").pattern));
    const auto brick =
        std::get<scene::Brick>(pigment("brick rgb 0 rgb 1 brick_size <1,2,3> mortar 0.1").pattern);
    CHECK(brick.size == geom::Vec3{1, 2, 3});
    CHECK(brick.mortar_width == 0.1);
    const auto gradient = std::get<scene::Gradient>(
        pigment("gradient y color_map { [0.5 rgb 1] [0 rgb 0] } frequency 2 phase 0.25 sine_wave")
            .pattern);
    CHECK(gradient.direction == geom::Vec3{0, 1, 0});
    CHECK(gradient.frequency == 2.0);
    CHECK(gradient.wave == scene::Gradient::Wave::sine);
    const auto& map = std::get<scene::ColorMap>(gradient.map);
    REQUIRE(map.entries.size() == 2);
    CHECK(map.entries[0].position == 0.0);
    const auto nested = std::get<scene::Gradient>(
        pigment("gradient x pigment_map { [0 rgb 1] [1 checker rgb 0 rgb 1] }").pattern);
    CHECK(std::holds_alternative<scene::Checker>(
        std::get<scene::PigmentMap>(nested.map).entries[1].pigment->pattern));
}

TEST_CASE("what of a finish is not rendered is warned of", "[lang]") {
    const auto warnings = [](const std::string& words) {
        return interpret("#version 3.7; sphere { 0, 1 finish { " + words + " } }").warnings;
    };
    CHECK(warnings("irid { 0.3 thickness 0.2 }").at(0).text ==
          "'irid' is read, but does nothing here");
    CHECK(warnings("diffuse 0.6, 0.3").size() == 1);
    CHECK(warnings("diffuse 0.6, 0").empty());
    CHECK(warnings("diffuse 0.6").empty());
}

TEST_CASE("finishes", "[lang]") {
    const auto plain = finish("");
    CHECK(plain.ambient == scene::Rgb{0.1});
    CHECK(plain.diffuse == 0.6);
    const auto f = finish(
        "ambient rgb <1,0,0> diffuse 0.5 phong 1 phong_size 80 specular 0.3 roughness 0.01 "
        "metallic conserve_energy crand 0.1");
    CHECK(f.ambient == scene::Rgb{1, 0, 0});
    CHECK(f.phong_size == 80.0);
    CHECK(f.metallic == 1.0);
    CHECK(f.conserve_energy);
    CHECK(finish("phong albedo 1 phong_size 39").phong == 20.0);
    CHECK(finish("reflection 0.5").reflection.min == scene::Rgb{0.5});
    const auto fresnel = finish("reflection { 1 fresnel }").reflection;
    CHECK(fresnel.fresnel);
    CHECK(fresnel.min == scene::Rgb{0.0});
    CHECK(finish("reflection { 0.5 }").reflection.min == scene::Rgb{0.5});
    const auto range = finish("reflection { 0.1, 0.9 falloff 3 exponent 2 metallic }").reflection;
    CHECK(range.min == scene::Rgb{0.1});
    CHECK(range.max == scene::Rgb{0.9});
    CHECK(range.falloff == 3.0);
    CHECK(range.metallic == 1.0);
}

TEST_CASE("interiors and their short form", "[lang]") {
    const auto i = interior(
        "interior { ior 1.33 priority 2 fade_distance 2 fade_power 1001 fade_color <.9,.5,.4> }");
    CHECK(i.ior == 1.33);
    CHECK(i.priority == 2.0);
    CHECK(i.states_ior);
    CHECK(i.states_priority);
    CHECK(i.fade.power == 1001.0);
    CHECK(i.fade.color.g == 0.5);
    const auto scene =
        read("sphere { 0, 1 material { ior 1.5 priority 3 absorption rgb <0.3, 0.1, 0.1> } }");
    CHECK(scene.solids[0].interior.absorption == scene::Rgb{0.3, 0.1, 0.1});
    CHECK(scene.textures[0].clear);
    CHECK_FALSE(read("sphere { 0, 1 material { ior 1.5 texture { pigment { rgbt 1 } } } }")
                    .textures[0]
                    .clear);
    CHECK_FALSE(read("sphere { 0, 1 material { ior 1.5 } pigment { rgb 1 } }").textures[0].clear);
    CHECK(interior("").ior == 1.0);
    CHECK_FALSE(interior("").states_ior);
    CHECK(interior("finish { refraction 1 ior 1.5 }").ior == 1.5);
}

TEST_CASE("the default texture holds where nothing is said", "[lang]") {
    const auto scene = read(
        "sphere { 0, 1 } #default { pigment { rgb x } finish { ambient 1 } } sphere { 0, 1 } "
        "sphere { 0, 1 finish { phong 1 } }");
    CHECK(std::get<scene::SolidColor>(scene.textures[0].pigment.pattern).color.rgb ==
          scene::Rgb{0.0});
    CHECK(std::get<scene::SolidColor>(scene.textures[1].pigment.pattern).color.rgb ==
          scene::Rgb{1, 0, 0});
    CHECK(scene.textures[2].finish.ambient == scene::Rgb{1.0});
    CHECK(scene.textures[2].finish.phong == 1.0);
}

TEST_CASE("a declared texture is modified where it is used", "[lang]") {
    const auto scene = read(
        "#declare T = texture { pigment { rgb x } finish { phong 1 } }\n"
        "sphere { 0, 1 texture { T finish { ambient 0 } } }");
    CHECK(scene.textures[0].finish.phong == 1.0);
    CHECK(scene.textures[0].finish.ambient == scene::Rgb{0.0});
}

TEST_CASE("settings", "[lang]") {
    const auto scene = read(
        "global_settings { max_trace_level 24 adc_bailout 1/255 interior { ior 1.0003 } "
        "contact_tolerance 1e-6 ambient_light rgb 2 }"
        "background { rgb <0,0,1> }");
    CHECK(scene.settings.max_trace_level == 24);
    CHECK(scene.settings.outside.ior == 1.0003);
    CHECK(scene.settings.contact_tolerance == 1e-6);
    CHECK(scene.settings.ambient_light == scene::Rgb{2.0});
    CHECK(scene.background.rgb == scene::Rgb{0, 0, 1});
    CHECK_FALSE(read("").settings.max_trace_level.has_value());
}

TEST_CASE("gamma depends on the version and on assumed_gamma", "[lang]") {
    CHECK(interpret("sphere { 0, 1 }").scene.settings.raw_output);
    CHECK(interpret("#version 3.6; sphere { 0, 1 }").scene.settings.raw_output);
    CHECK_FALSE(interpret("#version 3.7; sphere { 0, 1 }").scene.settings.raw_output);
    CHECK_FALSE(interpret("global_settings { assumed_gamma 1 }").scene.settings.raw_output);
    const auto space = [](const std::string& settings) {
        return interpret("global_settings { " + settings + " }").scene.settings.working_space;
    };
    CHECK(space("assumed_gamma 2.2") == scene::WorkingSpace{.gamma = 2.2});
    CHECK(space("assumed_gamma srgb").is_srgb);
    CHECK(space("assumed_gamma 1").is_linear());
}

// Measured with POV-Ray 3.7.0.10: #debug vstr(5, C, ",", 0, 6) of `color srgb 0.5`.
TEST_CASE("a colour in srgb is the same light under any assumed_gamma", "[lang]") {
    const auto red = [](const std::string& gamma) {
        const auto result = interpret("#version 3.7; global_settings { assumed_gamma " + gamma +
                                      " } #declare C = color srgb 0.5; #debug str(C.red, 0, 6)");
        return std::stod(result.messages);
    };
    CHECK(red("1") == Approx(0.214041).margin(1e-6));
    CHECK(red("2.2") == Approx(0.496227).margin(1e-6));
    CHECK(red("srgb") == 0.5);
}

TEST_CASE("assumed_gamma comes before colours in srgb, as in POV-Ray", "[lang]") {
    CHECK(error("#version 3.7; #declare C = color srgb 0.5; global_settings { assumed_gamma 2.2 }")
              .starts_with("assumed_gamma must be stated before"));
    CHECK(error("#version 3.7; #declare C = color srgb 0.5; global_settings { assumed_gamma 1 }")
              .empty());
    CHECK(error("#declare C = color srgb 0.5; global_settings { assumed_gamma 1 }")
              .starts_with("assumed_gamma must be stated before"));
}

TEST_CASE("skies", "[lang]") {
    const auto sky =
        read("sky_sphere { pigment { rgb x } pigment { rgbt 1 } emission 2 rotate 90*y }")
            .sky_sphere;
    CHECK(sky.pigments.size() == 2);
    CHECK(sky.emission == 2.0);
    CHECK_FALSE(sky.pigments[0].transform.is_identity());
}

}  // namespace meniscus::lang::test
