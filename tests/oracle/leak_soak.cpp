// Counts leaks over random scenes of every closed shape: leak_soak FIRST SEGMENTS. Goes on from
// seed FIRST until that many segments were followed, each checked at an inner point; one scene of
// 61 is also rendered by the paper's method (recast), at several offsets. Prints each seed that
// leaks, and a table at the end and every twenty scenes.

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <string>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"

using namespace meniscus;

namespace {

/// Every seed has a kind of scene of its own.
oracle::RandomSceneOptions options_of(std::uint64_t seed) {
    oracle::RandomSceneOptions options;
    options.fewest_solids = 2;
    options.most_solids = 12;
    options.rotated = seed % 2 == 1;
    options.stretched = seed % 3 == 1;
    options.sheared = seed % 5 == 1;
    options.cones = options.tori = options.lathes = options.meshes = true;
    options.unions = seed % 3 == 2;
    options.complements = seed % 7 == 1;
    options.textured = seed % 4 == 3;
    options.opaque_members = seed % 5 == 3;
    if (seed % 11 == 3) options.scale = 1e-6;
    if (seed % 11 == 7) options.scale = 1e6;
    if (seed % 13 == 5) options.offset = {1000.3, 777.7, -1234.1};
    if (seed % 13 == 9) options.offset = {1000000.3, 700007.7, -1234567.1};
    return options;
}

struct Count {
    std::uint64_t segments = 0, leaks = 0;
    std::map<std::string, std::uint64_t> by_kind;

    void add(const tracer::Statistics& statistics) {
        segments += statistics.segments;
        leaks += statistics.leaks;
        for (const auto& [key, count] : statistics.leaks_by_object) by_kind[key.second] += count;
    }
    std::string text() const {
        std::string result = fmt::format("{} segments, {} leaks, {:.3g} per million", segments,
                                         leaks, 1e6 * double(leaks) / double(segments));
        for (const auto& [kind, count] : by_kind) result += fmt::format("; {} {}", count, kind);
        return result;
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "usage: leak_soak FIRST SEGMENTS\n");
        return 2;
    }
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
    const double wanted = std::strtod(argv[2], nullptr);
    oracle::Picture picture{.width = 128, .height = 96, .limits = {.depth = 16, .cutoff = 1e-4}};
    const tracer::Options ours = oracle::options_for(picture);
    picture.interior = tracer::InteriorMode::recast;
    tracer::Options papers = oracle::options_for(picture);

    Count count;
    std::map<double, Count> recast;
    const auto print_table = [&](std::uint64_t next) {
        fmt::print("seeds {} to {}: {}\n", first, next - 1, count.text());
        for (const auto& [epsilon, c] : recast)
            fmt::print("  recast, offset {:.2g} of the size: {}\n", epsilon, c.text());
        std::fflush(stdout);
    };
    std::uint64_t seed = first;
    for (; double(count.segments) < wanted; ++seed) {
        const auto scene = tracer::compile(oracle::random_scene(seed, options_of(seed)));
        const auto rendered = tracer::render(scene, ours);
        count.add(rendered.statistics);
        if (rendered.statistics.leaks > 0) {
            fmt::print(
                "seed {}: {} leaks in {} segments; first: {} of {} at {:.17g} {:.17g} "
                "{:.17g}\n",
                seed, rendered.statistics.leaks, rendered.statistics.segments,
                rendered.statistics.first_leaks[0].kind,
                scene.source.objects[rendered.statistics.first_leaks[0].object].name,
                rendered.statistics.first_leaks[0].position.x,
                rendered.statistics.first_leaks[0].position.y,
                rendered.statistics.first_leaks[0].position.z);
            std::fflush(stdout);
        }
        if (seed % 61 == 0) {
            for (const double epsilon :
                 {32.0 * 0x1p-52, 1e-11, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
                papers.recast_epsilon = epsilon;
                recast[epsilon].add(tracer::render(scene, papers).statistics);
            }
        }
        if ((seed + 1 - first) % 20 == 0) print_table(seed + 1);
    }
    print_table(seed);
    return count.leaks == 0 ? 0 : 4;
}
