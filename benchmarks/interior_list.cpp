#include "tracer/interior_list.hpp"

#include <benchmark/benchmark.h>

#include "scene/scene.hpp"

namespace meniscus::benchmarks {
namespace {

using namespace tracer;

/// Concentric balls, the inner ones of higher priority.
RenderScene nest(int depth) {
    scene::Scene scene;
    for (int i = 0; i < depth; ++i) {
        scene::Interior interior;
        interior.ior = 1.1 + 0.01 * i;
        interior.priority = i;
        interior.states_ior = interior.states_priority = true;
        scene.solids.push_back({"ball", {}, interior});
        scene::Object object;
        object.shape = geom::Sphere{geom::Vec3{0.0}, 1.0 - double(i) / (depth + 1)};
        object.solid = scene.solids.size() - 1;
        scene.textures.push_back(scene::Texture::clear_skin());
        object.texture = scene.textures.size() - 1;
        scene.objects.push_back(std::move(object));
    }
    return compile(std::move(scene));
}

/// All the way in and out again; time is for one crossing.
void enter_and_leave(benchmark::State& state) {
    const int depth = int(state.range(0));
    const auto scene = nest(depth);
    for (auto _ : state) {
        InteriorList list;
        for (int part = 0; part < depth; ++part) {
            list.enter(part);
            benchmark::DoNotOptimize(list.top_solid(scene));
        }
        for (int part = depth - 1; part >= 0; --part) {
            list.leave(part);
            benchmark::DoNotOptimize(list.top_solid(scene));
        }
    }
    state.counters["crossings"] =
        benchmark::Counter(double(2 * depth), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(enter_and_leave)->Arg(1)->Arg(3)->Arg(6)->Arg(24);

/// Where a ray splits, both halves take the list.
void copy(benchmark::State& state) {
    InteriorList list;
    for (int part = 0; part < int(state.range(0)); ++part) list.enter(part);
    for (auto _ : state) {
        InteriorList other = list;
        benchmark::DoNotOptimize(other);
    }
}
BENCHMARK(copy)->Arg(0)->Arg(3)->Arg(6)->Arg(24);

}  // namespace
}  // namespace meniscus::benchmarks
