// Counts leaks over random scenes of every closed shape: leak_soak FIRST SEGMENTS. Goes on from
// seed FIRST until that many segments were followed. All of them are counted. Besides, in one scene
// of 17 each segment is asked at its inner points (--strict), in each scene 100 segments of other
// walks are asked at a point in quad precision, and one scene of 61 is also rendered by the paper's
// method (recast) at several offsets. Prints each seed that leaks, and the table so far every 200
// scenes: a run that is stopped is an honest shorter one.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_scene.hpp"
#include "tests/oracle/segment_check.hpp"

using namespace meniscus;

namespace {

/// Stands for an offset of 32 units in the last place of the scene's coordinates.
constexpr double ulps = 0.0;

struct Count {
    std::uint64_t scenes = 0, segments = 0, leaks = 0;
    std::map<std::string, std::uint64_t> by_kind;

    void add(const tracer::Statistics& statistics) {
        ++scenes;
        segments += statistics.segments;
        leaks += statistics.leaks;
        for (const auto& [key, count] : statistics.leaks_by_object) by_kind[key.second] += count;
    }
    std::string text() const {
        std::string result =
            fmt::format("{} scenes, {} segments, {} leaks, {:.3g} per million", scenes, segments,
                        leaks, 1e6 * double(leaks) / double(std::max<std::uint64_t>(segments, 1)));
        for (const auto& [kind, count] : by_kind) result += fmt::format("; {} {}", count, kind);
        return result;
    }
};

/// All that a run has counted.
struct Table {
    std::uint64_t first = 0, next = 0;
    Count all{}, strict{};
    oracle::SegmentCheck points{};
    std::map<std::pair<bool, double>, Count> recast{};  // scattered or not, offset

    void print() const {
        fmt::print("seeds {} to {}\n", first, next - 1);
        fmt::print("  all: {}\n", all.text());
        fmt::print("  of these asked at inner points: {}\n", strict.text());
        fmt::print("  points in quad precision: {}, {} wrong, {} leaks\n", points.segments,
                   points.wrong, points.leaks);
        for (const auto& [kind, count] : recast)
            fmt::print(
                "  recast, {}, offset {}: {}\n", kind.first ? "scattered" : "lattice",
                kind.second == ulps ? "32 ulp" : fmt::format("{:.0e} of the size", kind.second),
                count.text());
        std::fflush(stdout);
    }
};

void print_leak(std::uint64_t seed, const tracer::RenderScene& scene,
                const tracer::Statistics& statistics) {
    const tracer::Leak& leak = statistics.first_leaks[0];
    fmt::print("seed {}: {} leaks in {} segments; first: {} of {} at {:.17g} {:.17g} {:.17g}\n",
               seed, statistics.leaks, statistics.segments, leak.kind,
               scene.source.objects[leak.object].name, leak.position.x, leak.position.y,
               leak.position.z);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "usage: leak_soak FIRST SEGMENTS\n");
        return 2;
    }
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
    const double wanted = std::strtod(argv[2], nullptr);
    oracle::Picture picture{.width = 64, .height = 48, .limits = {.depth = 16, .cutoff = 1e-4}};
    tracer::Options ours = oracle::options_for(picture);
    picture.interior = tracer::InteriorMode::recast;
    tracer::Options papers = oracle::options_for(picture);

    Table table{.first = first, .next = first};
    while (double(table.all.segments) < wanted) {
        const std::uint64_t seed = table.next++;
        const auto options = oracle::every_kind(seed);
        const auto source = oracle::random_scene(seed, options);
        const auto scene = tracer::compile(source);
        ours.check_segments = seed % 17 == 0;
        const auto counted = tracer::render(scene, ours).statistics;
        table.all.add(counted);
        if (ours.check_segments) table.strict.add(counted);
        if (counted.leaks > 0) print_leak(seed, scene, counted);

        const auto points = oracle::check_segments(source, seed, 100);
        table.points.segments += points.segments;
        table.points.wrong += points.wrong;
        table.points.leaks += points.leaks;
        if (points.wrong + points.leaks > 0)
            fmt::print("seed {}: {} points wrong, {} leaks on the way\n", seed, points.wrong,
                       points.leaks);
        if (seed % 61 == 0) {
            const double far = geom::max_abs(source.camera.location) + scene.size;
            for (const double offset : {ulps, 1e-11, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
                papers.recast_epsilon = offset == ulps ? 32.0 * 0x1p-52 * far / scene.size : offset;
                table.recast[{options.scattered, offset}].add(
                    tracer::render(scene, papers).statistics);
            }
        }
        if ((table.next - first) % 200 == 0) table.print();
    }
    table.print();
    return table.all.leaks + table.points.wrong + table.points.leaks == 0 ? 0 : 4;
}
