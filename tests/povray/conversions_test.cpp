// The conversions of docs/povray.md: a .pov and what became of it, a .scene.

#include <catch2/catch.hpp>
#include <filesystem>

#include "povray/run.hpp"
#include "tests/povray/difference.hpp"
#include "tests/povray/golden.hpp"

using namespace meniscus;

namespace {

constexpr int width = 160, height = 120;
constexpr double rounding = 1e-5;  // RMSE of values in steps of 1/65535: 4.4e-6

std::filesystem::path conversion(const std::string& name) {
    return std::filesystem::path(CONVERSIONS_FOLDER) / name;
}

image::Image before(const std::string& name) {
    auto run = povray::run(conversion(name + ".pov"), {.width = width, .height = height});
    CHECK(run.warnings.empty());
    return std::move(run.picture);
}

image::Image after(const std::string& name, const test::Expectation& model) {
    const auto scene = test::read_golden(conversion(name + ".scene"), width, height);
    const auto ours = test::render_golden(scene, model, width, height);
    CHECK(ours.statistics.leaks == 0);
    const auto theirs = povray::run_text(test::export_golden(scene, model).text,
                                         {.width = width, .height = height});
    const auto difference = test::difference_off_edges(theirs.picture, ours.picture);
    INFO(name << ", " << model.text << ", its export: " << difference.text());
    CHECK(difference.rmse < 5e-5);
    return ours.picture;
}

const test::Expectation contact{povray::Model::contact, 0.0, 0.0, 0.0, "contact"};
const test::Expectation films{povray::Model::gap, 1e-3, 0.0, 0.0, "gap"};

}  // namespace

TEST_CASE("what CSG said, priorities say: the picture stays", "[povray][conversion]") {
    for (const std::string name : {"difference", "merge", "lens"}) {
        const auto difference = test::difference_off_edges(before(name), after(name, contact));
        INFO(name << ": " << difference.text());
        CHECK(difference.rmse < rounding);
        CHECK(difference.share_off < 1e-3);
    }
}

TEST_CASE("a gap is a film of air: with the film the picture stays, without it changes",
          "[povray][conversion]") {
    const auto gap = before("gap");
    const auto with_film = test::difference_off_edges(gap, after("gap", films));
    INFO(with_film.text());
    // At a scale of 1 POV-Ray misses hits within a tenth of the film.
    CHECK(with_film.rmse < 5e-4);
    // Total reflection from glass to air, where there is none from glass to water.
    CHECK(test::difference(gap, after("gap", contact)).rmse > 0.03);
}

TEST_CASE("an overlap is another picture, with priorities that of contact",
          "[povray][conversion]") {
    const auto overlap = after("overlap", contact);
    CHECK(test::difference(before("overlap"), overlap).rmse > 0.01);
    CHECK(test::difference(after("gap", contact), overlap).rmse < 1e-6);
}
