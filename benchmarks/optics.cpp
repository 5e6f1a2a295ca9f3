#include <benchmark/benchmark.h>

#include "benchmarks/rays.hpp"
#include "tracer/fresnel.hpp"

namespace meniscus::benchmarks {
namespace {

using geom::Vec3;

/// From glass into air, so that some are totally reflected.
constexpr double eta = 1.5;

void reflectance(benchmark::State& state) {
    const auto rays = rays_from_inside(1.0);
    std::size_t next = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            tracer::fresnel_reflectance(eta, std::abs(rays[next++ % rays.size()].direction.z)));
}
BENCHMARK(reflectance);

void reflected_direction(benchmark::State& state) {
    const auto rays = rays_from_inside(1.0);
    std::size_t next = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            tracer::reflect(rays[next++ % rays.size()].direction, Vec3{0.0, 0.0, 1.0}));
}
BENCHMARK(reflected_direction);

void refracted_direction(benchmark::State& state) {
    const auto rays = rays_from_inside(1.0);
    std::size_t next = 0;
    for (auto _ : state) {
        const Vec3& direction = rays[next++ % rays.size()].direction;
        const Vec3 normal{0.0, 0.0, direction.z > 0.0 ? -1.0 : 1.0};
        benchmark::DoNotOptimize(tracer::refract(direction, normal, eta));
    }
}
BENCHMARK(refracted_direction);

}  // namespace
}  // namespace meniscus::benchmarks
