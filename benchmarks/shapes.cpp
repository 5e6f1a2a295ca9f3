#include <benchmark/benchmark.h>

#include <string>

#include "benchmarks/rays.hpp"
#include "geom/shape.hpp"

namespace meniscus::benchmarks {
namespace {

using namespace geom;

/// One line against one shape: its interval if it is convex, else all crossings.
void cross(benchmark::State& state, const Shape& shape) {
    const auto rays = rays_from_outside(0.8);
    Crossings found;
    std::size_t next = 0, met = 0;
    for (auto _ : state) {
        const Ray& ray = rays[next++ % rays.size()];
        if (!is_closed(shape)) {
            found.clear();
            hits(shape, ray, found);
            met += !found.empty();
        } else if (is_convex(shape)) {
            met += interval(shape, ray, no_face).hit;
        } else {
            found.clear();
            crossings(shape, ray, found);
            met += !found.empty();
        }
    }
    state.counters["met"] = double(met) / double(state.iterations());
}

template <class... Primitives>
bool add_all(const std::variant<Primitives...>*) {
    (benchmark::RegisterBenchmark((std::string("crossings/") + Primitives::keyword).c_str(), cross,
                                  Shape(Primitives{})),
     ...);
    return true;
}

[[maybe_unused]] const bool added = add_all(static_cast<const Shape*>(nullptr));

}  // namespace
}  // namespace meniscus::benchmarks
