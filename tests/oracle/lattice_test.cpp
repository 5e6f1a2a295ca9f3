// Random scenes in which coincident faces and points of tangency are the rule.

#include <catch2/catch.hpp>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

/// All seeds count together; one seed that fails is named.
template <class Real>
void check_equal(std::uint64_t first_seed, std::uint64_t seeds, const RandomSceneOptions& options,
                 Picture picture = {}) {
    picture.limits.contact = contact_of(options);
    std::size_t pixels = 0, off = 0;
    for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
        const auto difference = compare<Real>(random_scene(seed, options), picture);
        INFO("seed " << seed << ": " << difference.text());
        CHECK(difference.leaks == 0);
        CHECK(difference.median < 1e-9);
        CHECK(difference.unexplained == 0);
        pixels += difference.pixels;
        off += difference.off;
    }
    INFO(off << " of " << pixels << " pixels off by more than 1e-6");
    CHECK(off * 10000 <= pixels);
}

}  // namespace

TEST_CASE("lattice scenes equal quad precision", "[oracle][lattice]") {
    check_equal<Quad>(1, 12, {});
}

TEST_CASE("lattice scenes along the axes", "[oracle][lattice]") {
    check_equal<Extended>(100, 40, {});
}

TEST_CASE("lattice scenes under rotations, each solid with an origin of its own",
          "[oracle][lattice]") {
    check_equal<Extended>(200, 40, {.rotated = true});
}

TEST_CASE("lattice scenes, each solid under a scaling of its own", "[oracle][lattice]") {
    check_equal<Extended>(300, 30, {.rotated = true, .stretched = true});
}

TEST_CASE("lattice scenes with cones and tori", "[oracle][lattice]") {
    check_equal<Extended>(400, 30, {.rotated = true, .cones = true, .tori = true});
}

TEST_CASE("lattice scenes with painted skins, opaque members and complements",
          "[oracle][lattice]") {
    check_equal<Extended>(500, 40,
                          {.rotated = true,
                           .cones = true,
                           .textured = true,
                           .opaque_members = true,
                           .complements = true});
}

TEST_CASE("lattice scenes, very small, very large and far away", "[oracle][lattice]") {
    check_equal<Extended>(600, 8, {.rotated = true, .scale = 1e-6});
    check_equal<Extended>(620, 8, {.rotated = true, .scale = 1e6});
    check_equal<Extended>(640, 8, {.rotated = true, .offset = {1000.3, 777.7, -1234.1}});
    check_equal<Extended>(660, 8, {.rotated = true, .offset = {1000000.3, 700007.7, -1234567.1}});
}

TEST_CASE("a double-precision classifier does as well as quad precision away from ties",
          "[oracle][lattice]") {
    check_equal<double>(700, 20, {});
}
