#include <catch2/catch.hpp>

#include "inspect/diagram.hpp"
#include "inspect/json_report.hpp"
#include "inspect/text_report.hpp"
#include "tests/inspect/scenes.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

/// Whether all parts stand in the text, one behind the other.
bool has_in_order(const std::string& text, const std::vector<std::string>& parts) {
    std::size_t at = 0;
    for (const auto& part : parts) {
        at = text.find(part, at);
        if (at == std::string::npos) {
            UNSCOPED_INFO("not found in order: " << part << " in\n" << text);
            return false;
        }
        at += part.size();
    }
    return true;
}

const Traced& example() {
    static const Traced traced(glass_over_water(), ray({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}));
    return traced;
}

}  // namespace

TEST_CASE("the text reads as the paper's four panels", "[inspect]") {
    const auto& e = example();
    const auto text = inspect::format_text(e.scene, e.names, e.trace);
    CHECK(has_in_order(
        text,
        {"0: camera ray, weight 1", "from <0, 0, -1> towards <0, 0, 1>", "list: empty\n",
         "t 1: enters Glass (test.scene:1), true: Glass (priority 2) replaces the outside",
         "list: Glass\n",
         "the outside -> Glass: n 1 -> 1.5, incidence 0 degrees, R 0.04, "
         "T 0.96",
         "1: refracted from 0", "list: Glass\n",
         "t 1: enters Water (test.scene:2), false: Water (priority 1) is below Glass "
         "(priority 2), which is there",
         "list: Glass, Water\n",
         "t 2: leaves Glass (test.scene:1), true: Glass (priority 2) ends and Water "
         "(priority 1) is next",
         "list: Water\n", "leaves Water", "list: empty\n", "escapes to the sky", "colour <"}));
}

TEST_CASE("what is not followed says why", "[inspect]") {
    auto scene = glass_over_water();
    scene.settings.max_trace_level = 2;
    const Traced shallow(scene, ray({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}));
    CHECK(has_in_order(inspect::format_text(shallow.scene, shallow.names, shallow.trace),
                       {"not followed: the tree's depth ends here"}));
    scene.settings.max_trace_level = 9;
    scene.settings.adc_bailout = 0.1;
    const Traced light(scene, ray({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}));
    CHECK(has_in_order(inspect::format_text(light.scene, light.names, light.trace),
                       {"not followed: its weight is too low"}));
}

TEST_CASE("the JSON says the same as data", "[inspect]") {
    const auto& e = example();
    const auto json =
        inspect::Json::parse(inspect::dump(inspect::format_json(e.scene, e.names, e.trace)));
    const auto& segments = json.at("segments");
    REQUIRE(segments.size() == e.trace.segments.size());
    const auto& in_glass = segments.at(1);
    CHECK(in_glass.at("branch") == "refracted");
    CHECK(in_glass.at("parent") == 0);
    CHECK(in_glass.at("list") == inspect::Json::parse(R"([{"solid": "Glass"}])"));
    const auto& crossing = in_glass.at("crossings").at(0);
    CHECK(crossing.at("object") == "Water");
    CHECK(crossing.at("line") == 2);
    CHECK(crossing.at("true") == false);
    CHECK(crossing.at("list_after").size() == 2);
    CHECK(in_glass.at("surface").at("ior_after") == 1.33);
    CHECK(segments.at(0).at("surface").at("reflectance").at(0).get<double>() == Approx(0.04));
}

TEST_CASE("the diagram shows true crossings filled, false ones hollow", "[inspect]") {
    const auto& e = example();
    const auto svg = inspect::draw_diagram(e.scene, e.names, e.trace);
    CHECK(svg.starts_with("<svg xmlns="));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(has_in_order(svg, {"fill=\"white\" stroke=\"#2ca02c\"", "into Water: false"}));
    CHECK(has_in_order(svg, {"fill=\"#1f77b4\" stroke=\"#1f77b4\"", "into Glass: true"}));
    CHECK(has_in_order(svg, {"Glass (priority 2), ior 1.5", "Water (priority 1), ior 1.33"}));
}

TEST_CASE("a diagram of a ray that meets nothing is still a picture", "[inspect]") {
    const Traced traced(scene::Scene{}, ray({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}));
    const auto svg = inspect::draw_diagram(traced.scene, traced.names, traced.trace);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
}
