// POV-Ray's pictures of the examples' exports in contact, and ours: no pixel is off but where the
// exact picture jumps within half a pixel.

#include <catch2/catch.hpp>

#include "compare/comparison.hpp"
#include "compare/jump_regions.hpp"
#include "povray/grow.hpp"
#include "povray/run.hpp"
#include "tests/povray/golden.hpp"

using namespace meniscus;

namespace {

const test::Expectation contact{povray::Model::contact, 0.0, 5e-5, 0.3, "contact"};

struct Pictures {
    scene::Scene scene;
    povray::Exported exported;
    image::Image theirs, ours;
};

Pictures render(const std::string& name, int width, int height) {
    Pictures result;
    result.scene = test::read_golden(std::filesystem::path(EXAMPLES_FOLDER) / (name + ".scene"),
                                     width, height);
    result.exported = test::export_golden(result.scene, contact);
    CHECK(result.exported.warnings.empty());
    auto theirs = povray::run_text(result.exported.text, {.width = width, .height = height});
    CHECK(theirs.warnings.empty());
    result.theirs = std::move(theirs.picture);
    auto ours = test::render_golden(result.scene, contact, width, height);
    CHECK(ours.statistics.leaks == 0);
    result.ours = std::move(ours.picture);
    return result;
}

compare::Comparison compare_pictures(const image::Image& theirs, const image::Image& ours,
                                     std::optional<compare::Regions> regions) {
    compare::Settings settings;
    settings.clip = true;
    return compare::compare({.name = "POV-Ray", .picture = theirs, .facts = {}, .command = ""},
                            {.name = "Meniscus", .picture = ours, .facts = {}, .command = ""},
                            settings, std::move(regions));
}

compare::Comparison compare_by_jumps(const Pictures& pictures) {
    tracer::Options options;
    options.width = pictures.ours.width;
    options.height = pictures.ours.height;
    options.sampling = tracer::GridSampling{1};
    return compare_pictures(
        pictures.theirs, pictures.ours,
        compare::regions_by_jumps(tracer::compile(pictures.scene), options, pictures.ours));
}

void check_off_edges(const compare::Comparison& comparison, double rmse) {
    for (std::size_t i = 0; i < comparison.by_region.size(); ++i) {
        if (comparison.regions.parts[i].name == "edges") continue;
        CHECK(comparison.by_region[i].rmse <= rmse);
    }
}

}  // namespace

// Figure 3 of Schmidt and Budge (2002), absorbing, with ice and bubbles.
TEST_CASE("the paper's glass of water, in contact, looks the same in POV-Ray", "[povray]") {
    const auto pictures = render("glass_of_water", 160, 120);
    const auto comparison = compare_by_jumps(pictures);
    CAPTURE(compare::format_text(comparison));
    CHECK(comparison.all.share_off() <= 0.003);
    check_off_edges(comparison, 5e-5);
    for (std::size_t i = 0; i < comparison.by_region.size(); ++i) {
        if (comparison.regions.parts[i].name == "edges") continue;
        CHECK(comparison.by_region[i].pixels > 500);
        CHECK(comparison.by_region[i].off == 0);
    }

    // Most of what is off is so by the hair by which POV-Ray's glass is larger: with the same hair
    // on ours less than half of it is left.
    auto with_hair = pictures.scene;
    for (auto& object : with_hair.objects) {
        if (object.name == "Glass") object = povray::grown(object, pictures.exported.overlap);
    }
    const auto larger = test::render_golden(with_hair, contact, 160, 120);
    const auto by_hair = compare_pictures(pictures.theirs, larger.picture, std::nullopt);
    CAPTURE(by_hair.all.off);
    CHECK(by_hair.all.off * 2 <= comparison.all.off + 1);
}

// The hair may show on edges: of these busy small pictures in up to 10 pixels, among the three
// hundred bubbles of `sparkling` in twice as many.
TEST_CASE("the export of every example looks the same in POV-Ray", "[povray]") {
    for (const auto& path : test::golden_scenes(EXAMPLES_FOLDER)) {
        const auto name = path.stem().string();
        const auto comparison = compare_by_jumps(render(name, 80, 60));
        INFO(name << '\n' << compare::format_text(comparison));
        check_off_edges(comparison, 5e-5);
        CHECK(comparison.all.off <= (name == "sparkling" ? 20 : 10));
    }
}
