#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using Catch::Contains;
using Json = nlohmann::json;

TEST_CASE("bench measures POV-Ray beside Meniscus, in contact and with a gap", "[bench]") {
    const Program program;
    program.write("nest.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
plane { y, -1.5 pigment { checker color rgb 0.9 color rgb 0.2 } finish { ambient 1 diffuse 0 } }
sphere { 0, 1 material { ior 1.5 priority 1 } }
sphere { 0, 0.7 material { ior 1.33 priority 2 } }
)");
    const auto result = program.run(
        "bench nest.scene --quick -W 32 -H 24 --spp 2,8 --reference-spp 64 --gap 1e-3 --json "
        "b.json");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const auto benchmark = Json::parse(program.read("b.json")).at("benchmarks").at(0);
    CHECK(benchmark.at("clipped") == true);
    for (const std::string model : {"contact", "gap"}) {
        double ours = 0.0, theirs = 0.0;
        for (const auto& row : benchmark.at("rows")) {
            INFO(row.dump());
            CHECK(!row.contains("failure"));
            const auto options = row.at("options").get<std::string>();
            if (options.find("max_trace_level 20, adc_bailout 0.001") == options.npos) continue;
            if (row.at("curve") == "Meniscus, " + model) ours = row.at("error").at("rmse");
            if (row.at("curve") == "POV-Ray, " + model && options.starts_with("-A,"))
                theirs = row.at("error").at("rmse");
        }
        // The same picture of pixel centres, as far from the reference.
        CHECK(ours > 0.01);
        CHECK(theirs == Approx(ours).epsilon(0.05));
    }
}

TEST_CASE("bench passes its limits to a source of POV-Ray's own", "[bench]") {
    const Program program;
    program.write("ball.pov", R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level MTL adc_bailout ADC }
#if (MTL != 20 | Side != 3) #error "not told" #end
camera { location <0, 0, -4> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy } interior { ior 1.5 } }
)");
    const auto result = program.run(
        "bench ball.scene --quick -W 16 -H 12 --models contact --spp 2 --reference-spp 16 "
        "--declare Side=3 --povray contact=ball.pov --json -");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const Json printed = Json::parse(result.out);
    for (const auto& row : printed.at("benchmarks").at(0).at("rows"))
        CHECK(!row.contains("failure"));
}
