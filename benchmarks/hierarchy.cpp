#include <benchmark/benchmark.h>

#include "benchmarks/rays.hpp"
#include "geom/bvh.hpp"
#include "geom/sphere.hpp"

namespace meniscus::benchmarks {
namespace {

using namespace geom;

/// The nearest of `state.range(0)` scattered spheres, which take up a tenth of their box.
void nearest_sphere(benchmark::State& state) {
    std::mt19937 random(3);
    const double radius = std::cbrt(0.1 * 8.0 / (4.19 * double(state.range(0))));
    std::vector<Sphere> spheres;
    std::vector<Bounds> boxes;
    for (std::int64_t i = 0; i < state.range(0); ++i) {
        spheres.push_back({random_point(random, 1.0), radius});
        boxes.push_back(spheres.back().bounds());
    }
    const Bvh bvh(boxes);
    const auto rays = rays_from_inside(1.0);
    std::size_t next = 0, visits = 0;
    for (auto _ : state) {
        const Ray& ray = rays[next++ % rays.size()];
        double nearest = infinity;
        bvh.traverse(ray, nearest, [&](std::uint32_t i) {
            ++visits;
            const Interval interval = spheres[i].interval(ray, no_face);
            if (interval.hit && interval.t1 > 0.0)
                nearest = std::min(nearest, interval.t0 > 0.0 ? interval.t0 : interval.t1);
        });
        benchmark::DoNotOptimize(nearest);
    }
    state.counters["visits"] = double(visits) / double(state.iterations());
}
BENCHMARK(nearest_sphere)->Arg(100)->Arg(10'000)->Arg(1'000'000);

void build_over_spheres(benchmark::State& state) {
    std::mt19937 random(3);
    std::vector<Bounds> boxes;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        boxes.push_back(Sphere{random_point(random, 1.0), 0.01}.bounds());
    for (auto _ : state) {
        const Bvh bvh(boxes);
        benchmark::DoNotOptimize(bvh.memory_bytes());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(build_over_spheres)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace meniscus::benchmarks
