#include "tracer/film_passes.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "tracer/camera_rays.hpp"

namespace meniscus::tracer {
namespace {

constexpr int small_tile = 16, large_tile = 32;  // pixels; rays one at a time, or in lanes
constexpr std::size_t samples_at_once = 64;      // as many as lanes ask for

}  // namespace

/// Where the light of samples goes when they have gone through lanes.
struct FilmPasses::Target {
    HalfPixel* half;
    Tally* tally;
};

/// What one thread needs to follow rays.
struct FilmPasses::Worker {
    Worker(const RenderScene& scene, const Options& options, const lanes::Program* program)
        : tree(scene, options, statistics) {
        if (program) host.emplace(scene, options, *program, tree, statistics);
    }
    Statistics statistics;
    RayTree tree;
    std::optional<LaneHost> host;  // if rays go in lanes
    std::vector<Sample> samples;
    std::vector<Target> targets;
};

FilmPasses::FilmPasses(const RenderScene& scene, const Options& options)
    : scene_(scene),
      options_(options),
      film_(options),
      program_(options.kernel == Kernel::general ? NoLanes{"asked for"}
                                                 : make_lane_program(scene, options)),
      workers_([&] {
          return std::make_unique<Worker>(scene, options, std::get_if<lanes::Program>(&program_));
      }) {}

FilmPasses::~FilmPasses() = default;

std::string FilmPasses::why_general() const {
    const auto* none = std::get_if<NoLanes>(&program_);
    return none ? none->reason : std::string();
}

void FilmPasses::report(double share) {
    if (!options_.progress) return;
    const std::lock_guard lock(progress_mutex_);
    options_.progress(std::min(share, 1.0));
}

void FilmPasses::run(double from, double to, const Plan& plan) {
    const Region region = film_.region();
    const int tile_size = std::holds_alternative<NoLanes>(program_) ? small_tile : large_tile;
    const int across = (film_.width() + tile_size - 1) / tile_size;
    const int down = (film_.height() + tile_size - 1) / tile_size;
    std::vector<Statistics> by_tile(std::size_t(across) * down);
    std::atomic<int> finished = 0;
    tbb::parallel_for(0, across * down, [&](int tile) {
        if (interrupted()) return;
        Worker& worker = *workers_.local();
        worker.statistics = {};
        const int x0 = region.x0 + tile % across * tile_size,
                  y0 = region.y0 + tile / across * tile_size;
        const Region window{x0, y0, std::min(x0 + tile_size, region.x1),
                            std::min(y0 + tile_size, region.y1)};
        if (worker.host) {
            follow_in_lanes(worker, window, plan);
        } else {
            follow_singly(worker, window, plan);
        }
        by_tile[tile] = worker.statistics;
        report(from + (to - from) * ++finished / (across * down));
    });
    for (const Statistics& statistics : by_tile) statistics_.add(statistics);
}

void FilmPasses::follow_singly(Worker& worker, const Region& window, const Plan& plan) {
    for (int y = window.y0; y < window.y1; ++y) {
        for (int x = window.x0; x < window.x1; ++x) {
            if (interrupted()) return;
            worker.samples.clear();
            plan(x, y, worker.samples);
            const std::size_t pixel = film_.index(x, y);
            const std::uint64_t segments_before = worker.statistics.segments;
            for (const Sample& sample : worker.samples) {
                const geom::Ray ray = camera_ray(scene_.source.camera, sample.x, sample.y,
                                                 options_.width, options_.height);
                film_.add(pixel, worker.tree.radiance(ray, sample.key), sample.weight);
                if (film_.tally(pixel).samples == 1)
                    film_.keep_first_hit(x, y, worker.tree.first_hit);
            }
            film_.tally(pixel).cost += double(worker.statistics.segments - segments_before);
        }
    }
}

/// Samples are made when lanes ask for them. Each half of a pixel has a sum of its own.
void FilmPasses::follow_in_lanes(Worker& worker, const Region& window, const Plan& plan) {
    int x = window.x0, y = window.y0;
    const auto more = [&](std::vector<Sample>& samples) {
        while (y < window.y1 && samples.size() < samples_at_once) {
            const std::size_t first = samples.size();
            plan(x, y, samples);
            share_out(worker, std::span(samples).subspan(first), film_.index(x, y));
            if (++x < window.x1) continue;
            x = window.x0;
            y = interrupted() ? window.y1 : y + 1;
        }
    };
    const auto pixels = std::size_t(window.x1 - window.x0) * std::size_t(window.y1 - window.y0);
    worker.host->run(more, 2 * pixels);
    empty_into_film(worker);
}

/// Samples of one pixel go to its two halves in turn.
void FilmPasses::share_out(Worker& worker, std::span<Sample> samples, std::size_t pixel) {
    Tally& tally = film_.tally(pixel);
    for (std::size_t i = 0; i < std::min<std::size_t>(samples.size(), 2); ++i) {
        HalfPixel& half = film_.half(pixel, (std::size_t(tally.samples) + i) % 2 == 1);
        double weight = 0.0;
        for (std::size_t k = i; k < samples.size(); k += 2) {
            samples[k].target = std::uint32_t(worker.targets.size());
            weight += samples[k].weight;
        }
        half.weight += weight;
        worker.targets.push_back({&half, &tally});
    }
    tally.samples += int(samples.size());
}

/// Adds the light of the samples that were followed to their pixels.
void FilmPasses::empty_into_film(Worker& worker) {
    const double unit = 1.0 / std::get<lanes::Program>(program_).units;
    const std::int64_t* sum = worker.host->sums().data();
    for (const Target& target : worker.targets) {
        target.half->add({double(sum[0]) * unit, double(sum[1]) * unit, double(sum[2]) * unit});
        target.tally->cost += double(sum[3]);
        sum += 4;
    }
    worker.targets.clear();
}

}  // namespace meniscus::tracer
