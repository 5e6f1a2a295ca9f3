// The kernel for lanes makes the pictures of the general way, whatever the instruction set.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "lanes/kernel.hpp"
#include "lang/interpret.hpp"
#include "tests/oracle/random_scene.hpp"
#include "tests/tracer/scenes.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

const std::filesystem::path folder = SCENES_FOLDER;

tracer::RenderScene read(const std::string& name) {
    lang::Options reading;
    reading.image_width = 96;
    reading.image_height = 72;
    return tracer::compile(lang::interpret_file(folder / name, reading).scene);
}

tracer::Options options(tracer::Sampling sampling) {
    tracer::Options result;
    result.width = 96;
    result.height = 72;
    result.sampling = sampling;
    return result;
}

tracer::Rendered in_lanes(const tracer::RenderScene& scene, tracer::Options options,
                          const std::string& instruction_set = {}) {
    options.instruction_set = instruction_set;
    auto rendered = tracer::render(scene, options);
    INFO(rendered.why_general);
    CHECK(rendered.why_general.empty());
    return rendered;
}

tracer::Rendered one_by_one(const tracer::RenderScene& scene, tracer::Options options) {
    options.kernel = tracer::Kernel::general;
    return tracer::render(scene, options);
}

/// Pixels that differ by more than `tolerance`.
std::size_t off(const image::Image& a, const image::Image& b, double tolerance) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    std::size_t result = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        double largest = 0.0;
        for (std::size_t c = i; c < i + 3; ++c)
            largest = std::max(largest, std::abs(double(a.rgb[c]) - b.rgb[c]));
        result += largest > tolerance;
    }
    return result;
}

}  // namespace

// A ray tree is the same but where rounding decides: a pixel in a thousand may differ there.
TEST_CASE("lanes make the picture of the general way", "[lanes]") {
    const std::string name =
        GENERATE("tests/povray/bench/spheres.scene", "tests/povray/bench/tumbler.scene",
                 "examples/first_page.scene", "examples/cross_section.scene",
                 "examples/three_spheres.scene", "examples/lens.scene", "examples/doublet.scene",
                 "examples/ocean.scene", "examples/glass_of_water.scene", "tests/lanes/cups.scene",
                 "tests/lanes/shells.scene", "tests/lanes/held_in_drops.scene");
    const tracer::RenderScene scene = read(name);
    for (const tracer::Sampling& sampling :
         {tracer::Sampling{tracer::GridSampling{1}}, tracer::Sampling{tracer::CountSampling{4}}}) {
        const auto fast = in_lanes(scene, options(sampling));
        const auto sure = one_by_one(scene, options(sampling));
        INFO(name << ", " << sampling.index());
        CHECK(off(fast.picture, sure.picture, 1e-6) * 1000 <= std::size_t(96 * 72));
        const auto &a = fast.statistics, &b = sure.statistics;
        CHECK(a.leaks == 0);
        CHECK(a.camera_rays == b.camera_rays);
        // To pass from one solid to its like of the same priority is no event in lanes.
        CHECK(double(a.segments) <= 1.001 * double(b.segments));
        CHECK(double(a.true_crossings + a.false_crossings) ==
              Approx(double(b.true_crossings + b.false_crossings)).epsilon(2e-3));
        CHECK(double(a.reflected_rays) == Approx(double(b.reflected_rays)).epsilon(1e-3));
        CHECK(double(a.refracted_rays) == Approx(double(b.refracted_rays)).epsilon(1e-3));
        CHECK(double(a.shadow_rays) == Approx(double(b.shadow_rays)).epsilon(1e-3));
        CHECK(a.deepest_level == b.deepest_level);
        // Few rays are too close to call.
        CHECK(a.single_rays * 500 <= a.segments);
    }
}

// The kernel cannot tell which of two unlike solids of one priority was entered last: rays that
// are in both are followed by the general way, from where they were in neither.
TEST_CASE("where solids of one priority overlap, the one entered last is there in lanes too",
          "[lanes]") {
    const tracer::RenderScene scene = read("tests/lanes/ties.scene");
    for (const tracer::Sampling& sampling :
         {tracer::Sampling{tracer::GridSampling{1}}, tracer::Sampling{tracer::CountSampling{4}}}) {
        const auto fast = in_lanes(scene, options(sampling));
        const auto sure = one_by_one(scene, options(sampling));
        CHECK(off(fast.picture, sure.picture, 1e-6) * 1000 <= std::size_t(96 * 72));
        CHECK(fast.statistics.single_rays > 0);
        CHECK(fast.statistics.single_rays < fast.statistics.segments / 4);
    }
}

TEST_CASE("a camera in two solids of one priority sees the same in lanes", "[lanes]") {
    tracer::RenderScene scene = read("tests/lanes/ties.scene");
    scene.source.camera.location = {0.0, 1.0, 0.0};
    const auto fast = in_lanes(scene, options(tracer::GridSampling{1}));
    const auto sure = one_by_one(scene, options(tracer::GridSampling{1}));
    CHECK(off(fast.picture, sure.picture, 1e-6) * 1000 <= std::size_t(96 * 72));
    CHECK(fast.statistics.camera_rays == sure.statistics.camera_rays);
}

TEST_CASE("lanes see meshes in boxes and cylinders along the axes too", "[lanes]") {
    lang::Options reading;
    reading.declares = {{"Along", GENERATE("0", "1", "2", "3", "4", "5")}};
    const tracer::RenderScene scene = tracer::compile(
        lang::interpret_file(folder / "tests/lanes/along_the_axes.scene", reading).scene);
    const auto fast = in_lanes(scene, options(tracer::GridSampling{1}));
    const auto sure = one_by_one(scene, options(tracer::GridSampling{1}));
    CHECK(off(fast.picture, sure.picture, 1e-6) == 0);
    CHECK(fast.statistics.leaks == 0);
    // Neither way sees nothing.
    std::size_t red = 0;
    for (std::size_t i = 0; i < sure.picture.rgb.size(); i += 3)
        red += sure.picture.rgb[i] > 0.8 && sure.picture.rgb[i + 2] < 0.2;
    CHECK(red > 50);
}

TEST_CASE("of coincident opaque surfaces both ways show that which the scene has first",
          "[lanes]") {
    scene::Scene source;
    test::look(source, {0.7, 1.6, -6.0});
    const auto add_box = [&](double top, const scene::Rgb& color) {
        test::add_opaque(source, geom::Box{{-1.0, -1.0, -1.0}, {1.0, top, 1.0}},
                         test::emissive(test::plain(color)));
    };
    add_box(1.0, {0.0, 1.0, 0.0});
    add_box(0.0, {1.0, 0.0, 0.0});
    const auto scene = tracer::compile(source);
    for (const auto& rendered : {in_lanes(scene, options(tracer::GridSampling{1})),
                                 one_by_one(scene, options(tracer::GridSampling{1}))}) {
        std::size_t red = 0, green = 0;
        for (std::size_t i = 0; i < rendered.picture.rgb.size(); i += 3) {
            red += rendered.picture.rgb[i] > 0.0f;
            green += rendered.picture.rgb[i + 1] > 0.0f;
        }
        CHECK(red == 0);
        CHECK(green > 500);
    }
}

TEST_CASE("to pass between like media takes no level of rays that lanes hand over", "[lanes]") {
    const tracer::RenderScene scene = read("tests/lanes/last_level.scene");
    auto deep = options(tracer::GridSampling{1});
    deep.width = 48;
    deep.height = 36;
    deep.tree = tracer::Tree::full;
    deep.depth = GENERATE(5, 6, 7);
    const auto fast = in_lanes(scene, deep);
    CHECK(off(fast.picture, one_by_one(scene, deep).picture, 1e-6) == 0);
    CHECK(fast.statistics.single_rays > 0);
}

TEST_CASE("lanes follow rays through more solids than one word of a list holds", "[lanes]") {
    const tracer::RenderScene scene = read("tests/lanes/many_bubbles.scene");
    for (const tracer::Sampling& sampling :
         {tracer::Sampling{tracer::GridSampling{1}}, tracer::Sampling{tracer::CountSampling{4}}}) {
        const auto fast = in_lanes(scene, options(sampling));
        const auto sure = one_by_one(scene, options(sampling));
        CHECK(off(fast.picture, sure.picture, 1e-6) * 1000 <= std::size_t(96 * 72));
        CHECK(fast.statistics.single_rays * 500 <= fast.statistics.segments);
    }
}

TEST_CASE("every instruction set makes the same bytes", "[lanes]") {
    const auto sets = lanes::instruction_sets();
    REQUIRE(sets.back() == "plain");
    const std::string name = GENERATE(
        "tests/povray/bench/tumbler.scene", "examples/cross_section.scene",
        "tests/lanes/ties.scene", "tests/lanes/many_bubbles.scene", "tests/lanes/cups.scene",
        "tests/lanes/shells.scene", "tests/lanes/held_in_drops.scene");
    const tracer::RenderScene scene = read(name);
    for (const tracer::Sampling& sampling :
         {tracer::Sampling{tracer::GridSampling{1}}, tracer::Sampling{tracer::CountSampling{4}}}) {
        const auto plain = in_lanes(scene, options(sampling), "plain");
        for (const std::string& set : sets) {
            INFO(name << ", " << set);
            const auto other = in_lanes(scene, options(sampling), set);
            CHECK(other.picture.rgb == plain.picture.rgb);
            CHECK(other.statistics.segments == plain.statistics.segments);
            CHECK(other.statistics.false_crossings == plain.statistics.false_crossings);
        }
    }
}

TEST_CASE("the number of threads does not change a byte in lanes", "[lanes]") {
    const tracer::RenderScene scene = read("tests/povray/bench/tumbler.scene");
    tracer::Options one = options(tracer::CountSampling{2});
    one.threads = 1;
    tracer::Options three = one;
    three.threads = 3;
    CHECK(in_lanes(scene, one).picture.rgb == in_lanes(scene, three).picture.rgb);
}

TEST_CASE("an instruction set that is not there is refused", "[lanes]") {
    const tracer::RenderScene scene = read("examples/first_page.scene");
    tracer::Options wrong = options(tracer::GridSampling{1});
    wrong.instruction_set = "abacus";
    CHECK_THROWS_AS(tracer::render(scene, wrong), std::invalid_argument);
}

TEST_CASE("a scene that lanes cannot have says why", "[lanes]") {
    const auto rendered =
        tracer::render(read("examples/sparkling.scene"), options(tracer::GridSampling{1}));
    CHECK(rendered.why_general == "more than 241 solids");
}

// The short way for scenes without dielectrics against the way with lists, which checks take.
TEST_CASE("without a dielectric, pictures are those of the way with lists", "[tracer]") {
    const std::string name =
        GENERATE("benchmarks/scenes/opaque.scene", "tests/lanes/opaque_contacts.scene");
    const tracer::RenderScene scene = read(name);
    REQUIRE(!scene.has_members);
    for (const tracer::Sampling& sampling :
         {tracer::Sampling{tracer::GridSampling{1}}, tracer::Sampling{tracer::CountSampling{4}}}) {
        tracer::Options with_lists = options(sampling);
        with_lists.check_segments = true;
        const auto fast = one_by_one(scene, options(sampling));
        const auto sure = one_by_one(scene, with_lists);
        CHECK(fast.picture.rgb == sure.picture.rgb);
        CHECK(sure.statistics.leaks == 0);
        CHECK(fast.statistics.casts == sure.statistics.casts);
        CHECK(fast.statistics.true_crossings == sure.statistics.true_crossings);
        CHECK(fast.statistics.shadow_rays == sure.statistics.shadow_rays);
    }
}
