// Compares random scenes, seed after seed: oracle_soak FIRST LAST [rotated] [stretched] [cones]
// [tori] [textured] [members] [complements] [quad] [small] [large] [far]. Prints each seed that has
// a leak or a pixel off by more than 1e-6.

#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <string>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"

using namespace meniscus;

int main(int argc, char** argv) {
    if (argc < 3) {
        fmt::print(stderr, "usage: oracle_soak FIRST LAST [rotated] [cones] ...\n");
        return 2;
    }
    const std::set<std::string> words(argv + 3, argv + argc);
    oracle::RandomSceneOptions options;
    options.rotated = words.contains("rotated");
    options.stretched = words.contains("stretched");
    options.cones = words.contains("cones");
    options.tori = words.contains("tori");
    options.textured = words.contains("textured");
    options.opaque_members = words.contains("members");
    options.sheared = words.contains("sheared");
    options.lathes = words.contains("lathes");
    options.meshes = words.contains("meshes");
    options.unions = words.contains("unions");
    options.complements = words.contains("complements");
    if (words.contains("small")) options.scale = 1e-6;
    if (words.contains("large")) options.scale = 1e6;
    if (words.contains("far")) options.offset = {1000000.3, 700007.7, -1234567.1};
    oracle::Picture picture;
    picture.limits.contact = oracle::contact_of(options);

    std::size_t pixels = 0, off = 0, far_off = 0, unexplained = 0, leaks = 0;
    for (auto seed = std::strtoull(argv[1], nullptr, 10);
         seed <= std::strtoull(argv[2], nullptr, 10); ++seed) {
        const auto scene = oracle::random_scene(seed, options);
        const auto difference = words.contains("quad")
                                    ? oracle::compare<oracle::Quad>(scene, picture)
                                    : oracle::compare<oracle::Extended>(scene, picture);
        pixels += difference.pixels;
        off += difference.off;
        far_off += difference.far_off;
        leaks += difference.leaks;
        unexplained += difference.unexplained;
        if (difference.off > 0 || difference.leaks > 0)
            fmt::print("seed {}: {}\n", seed, difference.text());
    }
    fmt::print("{} pixels: {} off by 1e-6, {} by 2e-3, {} without a reason; {} leaks\n", pixels,
               off, far_off, unexplained, leaks);
    return off + leaks == 0 ? 0 : 4;
}
