// Sixty random scenes of every closed shape and every kind: no pixel is off without a reason.

#include <catch2/catch.hpp>
#include <set>
#include <string_view>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

constexpr std::uint64_t first_seed = 500'000;  // none of the seeds that the soaks start from

/// 48x36, pixel centres, the whole tree.
void check_explained(std::uint64_t first, std::uint64_t seeds) {
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
        const auto options = every_kind(seed);
        Picture picture;
        picture.limits.contact = contact_of(options);
        const auto difference = compare_closely(random_scene(seed, options), picture);
        INFO("seed " << seed << ": " << difference.text());
        CHECK(difference.leaks == 0);
        CHECK(difference.median < 1e-9);
        CHECK(difference.unexplained == 0);
    }
}

}  // namespace

// One sentence, in parts that can run side by side.
TEST_CASE("scenes of every shape equal the exact ones, 1 to 15", "[oracle][every]") {
    check_explained(first_seed, 15);
}
TEST_CASE("scenes of every shape equal the exact ones, 16 to 30", "[oracle][every]") {
    check_explained(first_seed + 15, 15);
}
TEST_CASE("scenes of every shape equal the exact ones, 31 to 45", "[oracle][every]") {
    check_explained(first_seed + 30, 15);
}
TEST_CASE("scenes of every shape equal the exact ones, 46 to 60", "[oracle][every]") {
    check_explained(first_seed + 45, 15);
}

TEST_CASE("the sixty scenes hold every closed shape, unions and complements", "[oracle][every]") {
    std::set<std::string_view> shapes;
    std::set<geom::Spline> splines;
    bool has_union = false, has_complement = false;
    for (std::uint64_t seed = first_seed; seed < first_seed + 60; ++seed) {
        const auto scene = random_scene(seed, every_kind(seed));
        has_union = has_union || scene.objects.size() > scene.solids.size();
        for (const scene::Object& object : scene.objects) {
            shapes.insert(geom::keyword(object.shape));
            if (const auto* lathe = std::get_if<geom::Lathe>(&object.shape))
                splines.insert(lathe->spline());
            has_complement = has_complement || object.inverse;
        }
    }
    CHECK(shapes == std::set<std::string_view>{"box", "cone", "cylinder", "lathe", "mesh", "plane",
                                               "sphere", "torus"});
    CHECK(splines.size() == 4);
    CHECK(has_union);
    CHECK(has_complement);
}
