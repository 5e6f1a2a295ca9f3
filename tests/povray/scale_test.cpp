#include "povray/scale.hpp"

#include <catch2/catch.hpp>

#include "lang/interpret.hpp"
#include "povray/precision.hpp"

using namespace meniscus;
using povray::Model;

namespace {

scene::Scene read(const std::string& text) {
    return lang::interpret_text("scale.scene", "camera { location <0, 0, -9> look_at 0 }\n" + text)
        .scene;
}

constexpr auto nest =
    "sphere { 0, 1 material { ior 1.5 priority 1 } }\n"
    "sphere { 0, 0.8 material { ior 1.33 priority 2 } }\n";

povray::Exported exported(const std::string& text, Model model, double gap = 0.0,
                          std::optional<double> scale = {}) {
    return povray::export_scene(read(text),
                                {.model = model, .gap = gap, .scale = scale, .source = ""});
}

}  // namespace

TEST_CASE("scales fit between what POV-Ray does not see for near and for far", "[export][scale]") {
    // The scene is some 10 units large.
    CHECK(exported(nest, Model::contact).scale == 1e3);
    CHECK(exported(nest, Model::plain).scale == 1e2);
    CHECK(exported(nest, Model::gap, 1e-3).scale == 1e2);
    CHECK(exported(nest, Model::gap, 1e-6).scale == 1e4);
    CHECK(exported(std::string(nest) + "plane { y, -2 material { ior 1.2 } }", Model::contact)
              .scale == 1e2);
    for (const auto model : {Model::contact, Model::plain, Model::gap})
        CHECK(exported(nest, model, model == Model::gap ? 1e-4 : 0.0).warnings.empty());
}

TEST_CASE("a scale that does not fit is told, with one that does", "[export][scale]") {
    using Catch::Contains;
    const auto floor = std::string(nest) + "plane { y, -2 pigment { rgb 1 } }";
    const auto ocean = std::string(nest) + "plane { y, -2 material { ior 1.33 } }";
    const struct {
        std::string text;
        Model model;
        double gap, scale;
        const char *what, *advice;
    } cases[] = {
        {nest, Model::contact, 0.0, 1.0, "solids overlap by 0.0011", "--scale 100 or more"},
        {nest, Model::gap, 1e-4, 1.0, "no film thinner than 0.001", "--scale 10 or more"},
        {nest, Model::plain, 0.0, 1e7, "nothing farther than 1", "--scale 1e+06 or less"},
        {floor, Model::plain, 0.0, 1e5, "nothing farther than 1e+02", "--scale 1000 or less"},
        {ocean, Model::contact, 0.0, 1e3, "nothing farther than 1e+04", "--scale 100 or less"}};
    for (const auto& c : cases) {
        const auto warnings = exported(c.text, c.model, c.gap, c.scale).warnings;
        INFO(c.text << " at " << c.scale);
        REQUIRE(warnings.size() == 1);
        CHECK_THAT(warnings.front(), Contains(c.what) && Contains(c.advice));
    }
}

TEST_CASE("POV-Ray's indices are of single precision, relative to the outside",
          "[export][precision]") {
    const auto scene = povray::with_povrays_iors(
        read("global_settings { interior { ior 1.33 } }\nsphere { 0, 1 material { ior 1.5 } }"));
    CHECK(scene.solids[0].interior.ior != 1.5);
    CHECK(scene.solids[0].interior.ior == Approx(1.5).epsilon(6e-8));
    CHECK(float(scene.solids[0].interior.ior / 1.33) ==
          Approx(scene.solids[0].interior.ior / 1.33).epsilon(1e-15));
    CHECK(povray::with_povrays_iors(read(nest)).solids[0].interior.ior == 1.5);
}
