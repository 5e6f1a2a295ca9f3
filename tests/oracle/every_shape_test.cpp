// Sixty random lattice scenes of every shape, against quad precision where lathes' polynomials
// need it.

#include <catch2/catch.hpp>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

TEST_CASE("sixty scenes of two to twelve solids of every shape", "[oracle][slow]") {
    for (std::uint64_t seed = 5000; seed < 5060; ++seed) {
        const bool lathes = seed % 4 == 0;
        const RandomSceneOptions options{.fewest_solids = 2,
                                         .most_solids = 12,
                                         .rotated = seed % 2 == 1,
                                         .stretched = seed % 3 == 1,
                                         .sheared = seed % 5 == 1,
                                         .cones = true,
                                         .tori = true,
                                         .lathes = lathes,
                                         .meshes = true,
                                         .unions = seed % 3 == 2,
                                         .textured = seed % 6 == 1,
                                         .opaque_members = seed % 6 == 3,
                                         .complements = seed % 7 == 1};
        Picture picture;
        picture.limits.contact = contact_of(options);
        const auto scene = random_scene(seed, options);
        const auto difference =
            lathes ? compare<Quad>(scene, picture) : compare<Extended>(scene, picture);
        INFO("seed " << seed << ": " << difference.text());
        CHECK(difference.leaks == 0);
        CHECK(difference.median < 1e-9);
        CHECK(difference.unexplained == 0);
    }
}
