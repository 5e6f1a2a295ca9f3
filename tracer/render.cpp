#include "tracer/render.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <mutex>

#include "tracer/adaptive.hpp"
#include "tracer/camera_rays.hpp"
#include "tracer/film.hpp"
#include "tracer/lane_host.hpp"
#include "tracer/lane_program.hpp"

namespace meniscus::tracer {
namespace {

constexpr int small_tile = 16, large_tile = 32;  // pixels; rays one at a time, or in lanes
constexpr int most_samples = 1 << 16;
constexpr std::size_t samples_at_once = 1 << 16;

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One of the two sums of a pixel's samples while they go in lanes.
struct Half {
    Pixel* pixel;
    bool is_odd;
    double weight = 0.0;
    int count = 0;
};

/// What one thread needs to follow rays.
struct Worker {
    Worker(const RenderScene& scene, const Options& options, const lanes::Program* program)
        : tree(scene, options, statistics) {
        if (program) host.emplace(scene, options, *program, tree, statistics);
    }
    Statistics statistics;
    RayTree tree;
    std::optional<LaneHost> host;  // if rays go in lanes
    std::vector<Sample> samples;
    std::vector<Half> halves;
};

/// Runs passes over the film, tile by tile on all cores. A pixel belongs to one tile, so no result
/// depends on threads.
class Renderer {
public:
    Renderer(const RenderScene& scene, const Options& options)
        : scene_(scene),
          options_(options),
          film_(options),
          program_(options.kernel == Kernel::general ? NoLanes{"asked for"}
                                                     : make_lane_program(scene, options)),
          workers_([&] {
              return std::make_unique<Worker>(scene, options,
                                              std::get_if<lanes::Program>(&program_));
          }) {}

    /// Why rays go one at a time; empty: they go in lanes.
    std::string why_general() const {
        const auto* none = std::get_if<NoLanes>(&program_);
        return none ? none->reason : std::string();
    }
    Film& film() { return film_; }
    const Statistics& statistics() const { return statistics_; }
    bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }

    void report(double share) {
        if (!options_.progress) return;
        const std::lock_guard lock(progress_mutex_);
        options_.progress(std::min(share, 1.0));
    }

    /// Follows the samples that plan(x, y, out) wants of each pixel: a list of where in the pixel
    /// and with what weight, each with a number of its own. The finished share goes from
    /// `share_from` to `share_to`.
    template <class Plan>
    void pass(double share_from, double share_to, Plan&& plan) {
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
            report(share_from + (share_to - share_from) * ++finished / (across * down));
        });
        for (const Statistics& statistics : by_tile) statistics_.add(statistics);
    }

    template <class Plan>
    void follow_singly(Worker& worker, const Region& window, Plan&& plan) {
        for (int y = window.y0; y < window.y1; ++y) {
            for (int x = window.x0; x < window.x1; ++x) {
                if (interrupted()) return;
                worker.samples.clear();
                plan(x, y, worker.samples);
                Pixel& pixel = film_.at(x, y);
                const std::uint64_t segments_before = worker.statistics.segments;
                for (const Sample& sample : worker.samples) {
                    const geom::Ray ray = camera_ray(scene_.source.camera, sample.x, sample.y,
                                                     options_.width, options_.height);
                    pixel.add(worker.tree.radiance(ray, sample.key), sample.weight);
                    if (pixel.samples == 1) pixel.first_hit = worker.tree.first_hit;
                }
                pixel.cost += double(worker.statistics.segments - segments_before);
            }
        }
    }

    /// Some ten thousand samples at a time, of as many pixels as that takes. Each half of a pixel
    /// has a sum of its own.
    template <class Plan>
    void follow_in_lanes(Worker& worker, const Region& window, Plan&& plan) {
        worker.samples.clear();
        std::vector<Half>& halves = worker.halves;
        for (int y = window.y0; y < window.y1; ++y) {
            for (int x = window.x0; x < window.x1; ++x) {
                const std::size_t first = worker.samples.size();
                plan(x, y, worker.samples);
                int number = film_.at(x, y).samples;
                const auto even = std::uint32_t(halves.size());
                halves.push_back({&film_.at(x, y), false});
                halves.push_back({&film_.at(x, y), true});
                for (std::size_t i = first; i < worker.samples.size(); ++i, ++number) {
                    Sample& sample = worker.samples[i];
                    sample.target = even + std::uint32_t(number % 2);
                    halves[sample.target].weight += sample.weight;
                    ++halves[sample.target].count;
                }
                if (worker.samples.size() < samples_at_once) continue;
                follow_in_lanes(worker, halves);
                if (interrupted()) return;
            }
        }
        follow_in_lanes(worker, halves);
    }

    void follow_in_lanes(Worker& worker, std::vector<Half>& halves) {
        if (!worker.samples.empty()) worker.host->run(worker.samples, halves.size());
        const double unit = 1.0 / std::get<lanes::Program>(program_).units;
        for (std::size_t i = 0; i < halves.size(); ++i) {
            const Half& half = halves[i];
            if (half.count == 0) continue;
            const std::int64_t* sum = &worker.host->sums()[4 * i];
            const scene::Rgb light{double(sum[0]) * unit, double(sum[1]) * unit,
                                   double(sum[2]) * unit};
            half.pixel->add_half(half.is_odd, light, half.weight, half.count);
            half.pixel->cost += double(sum[3]);
        }
        worker.samples.clear();
        halves.clear();
    }

    Sample sample_at(int x, int y, double u, double v, std::uint64_t number) const {
        const std::uint64_t pixel = std::uint64_t(y) * 0x100000000ull + std::uint64_t(x);
        return {.x = x + u, .y = y + v, .key = mix(mix(mix(options_.seed) + pixel) + number)};
    }

    void add_grid(int x, int y, int k, std::vector<Sample>& out) const {
        for (int j = 0; j < k; ++j) {
            for (int i = 0; i < k; ++i)
                out.push_back(
                    sample_at(x, y, (i + 0.5) / k, (j + 0.5) / k, std::uint64_t(j) * k + i));
        }
    }

    /// Goes on in the pixel's own low-discrepancy sets until it has `count` samples, which take
    /// turns among `sets` of them.
    void add_samples(int x, int y, int count, std::vector<Sample>& out, int sets = 1) const {
        const std::uint64_t seed =
            mix(mix(options_.seed ^ 0x5eed) + (std::uint64_t(y) << 32) + std::uint64_t(x));
        for (int index = film_.at(x, y).samples; index < count; ++index) {
            const int set = index % sets;
            const geom::Vec2 at = sobol_point(std::uint32_t(index / sets),
                                              set == 0 ? seed : mix(seed + std::uint64_t(set)));
            out.push_back(sample_at(x, y, at.x, at.y, std::uint64_t(index)));
        }
    }

    void render(const GridSampling& sampling, Rendered&) {
        pass(0.0, 1.0,
             [&](int x, int y, std::vector<Sample>& out) { add_grid(x, y, sampling.k, out); });
    }

    void render(const CountSampling& sampling, Rendered& result) {
        if (sampling.samples == 1) return render(GridSampling{1}, result);
        pass(0.0, 1.0, [&](int x, int y, std::vector<Sample>& out) {
            add_samples(x, y, sampling.samples, out);
        });
    }

    /// Doubles the samples where that is worth most, until the picture's estimated error is small
    /// enough. The two halves of a pixel's samples are of two sets that know nothing of each other:
    /// then the difference of their means tells the error of the mean of both, neither more nor
    /// less. (Halves of one set keep out of each other's way, and differ far more.)
    void render(const ErrorSampling& sampling, Rendered& result) {
        constexpr int first_samples = 8;
        constexpr int sets = 2;
        const auto pixel_count = double(film_.width()) * film_.height();
        const double allowed = sampling.error * sampling.error * pixel_count;
        pass(0.0, 0.3, [&](int x, int y, std::vector<Sample>& out) {
            add_samples(x, y, first_samples, out, sets);
        });
        double share = 0.3;
        while (!interrupted()) {
            const std::vector<PixelNeed> needs = pixel_needs();
            double sum = 0.0;
            for (const PixelNeed& need : needs) sum += need.squared_error;
            result.estimated_error = std::sqrt(sum / pixel_count);
            if (sum <= allowed) break;
            const std::vector<bool> chosen = choose_pixels(needs, allowed);
            if (std::ranges::find(chosen, true) == chosen.end()) break;
            const double next_share = share + 0.5 * (1.0 - share);
            pass(share, next_share, [&](int x, int y, std::vector<Sample>& out) {
                const Region region = film_.region();
                const auto i = std::size_t(y - region.y0) * film_.width() + (x - region.x0);
                if (chosen[i]) add_samples(x, y, 2 * film_.at(x, y).samples, out, sets);
            });
            share = next_share;
        }
    }

    std::vector<PixelNeed> pixel_needs() const {
        std::vector<PixelNeed> needs;
        const std::vector<double> errors = film_.squared_errors();
        needs.reserve(errors.size());
        const Region region = film_.region();
        for (int y = region.y0; y < region.y1; ++y)
            for (int x = region.x0; x < region.x1; ++x)
                needs.push_back({errors[needs.size()],
                                 std::max(film_.at(x, y).cost, double(film_.at(x, y).samples)),
                                 film_.at(x, y).samples < most_samples});
        return needs;
    }

    /// Whole rounds over all pixels while there is time for one more; the count that was reached
    /// makes the same picture again.
    void render(const TimeSampling& sampling, Rendered& result) {
        const Stopwatch watch;
        int samples = 0;
        for (int next = 2; !interrupted(); next = samples + std::max(1, samples / 2)) {
            const double before = watch.seconds();
            pass(std::min(1.0, before / sampling.seconds), std::min(1.0, before / sampling.seconds),
                 [&](int x, int y, std::vector<Sample>& out) { add_samples(x, y, next, out); });
            const double per_sample = (watch.seconds() - before) / (next - samples);
            samples = next;
            if (watch.seconds() + per_sample >= sampling.seconds || samples >= (1 << 20)) break;
            const int affordable = int((sampling.seconds - watch.seconds()) / per_sample);
            if (affordable < std::max(1, samples / 2)) {
                pass(1.0, 1.0, [&](int x, int y, std::vector<Sample>& out) {
                    add_samples(x, y, samples + affordable, out);
                });
                samples += affordable;
                break;
            }
        }
        result.reproduce = {{"spp", std::to_string(samples)},
                            {"tree", std::string(name(implied_tree(options_)))}};
    }

    /// POV-Ray's anti-aliasing: supersample pixels that differ from their left or upper neighbour.
    void render(const ContrastSampling& sampling, Rendered&) {
        pass(0.0, 0.5, [&](int x, int y, std::vector<Sample>& out) { add_grid(x, y, 1, out); });
        const Region region = film_.region();
        std::vector<char> marked(std::size_t(film_.width()) * film_.height(), 0);
        const auto index = [&](int x, int y) {
            return std::size_t(y - region.y0) * film_.width() + (x - region.x0);
        };
        const auto contrast = [&](int x, int y, int u, int v) {
            const scene::Rgb a = glm::clamp(film_.at(x, y).mean(), 0.0, 1.0),
                             b = glm::clamp(film_.at(u, v).mean(), 0.0, 1.0);
            const scene::Rgb d =
                glm::abs(glm::pow(a, scene::Rgb{1.0 / 2.5}) - glm::pow(b, scene::Rgb{1.0 / 2.5}));
            return d.r + d.g + d.b;
        };
        for (int y = region.y0; y < region.y1; ++y) {
            for (int x = region.x0; x < region.x1; ++x) {
                const bool left = x > region.x0 && contrast(x, y, x - 1, y) >= sampling.threshold;
                const bool above = y > region.y0 && contrast(x, y, x, y - 1) >= sampling.threshold;
                if (left || above || sampling.threshold <= 0.0) marked[index(x, y)] = 1;
                if (left) marked[index(x - 1, y)] = 1;
                if (above) marked[index(x, y - 1)] = 1;
            }
        }
        pass(0.5, 1.0, [&](int x, int y, std::vector<Sample>& out) {
            if (!marked[index(x, y)]) return;
            if (sampling.method == 1) return add_grid(x, y, sampling.depth, out);
            // Method 2 at its full depth: corners and edges of the pixel too, by trapezoidal
            // weights.
            Pixel& pixel = film_.at(x, y);
            const FirstHit first_hit = pixel.first_hit;
            pixel = {};
            pixel.first_hit = first_hit;
            const int n = 1 << (sampling.depth - 1);
            for (int j = 0; j <= n; ++j) {
                for (int i = 0; i <= n; ++i) {
                    const double weight = (i % n == 0 ? 0.5 : 1.0) * (j % n == 0 ? 0.5 : 1.0);
                    out.push_back(sample_at(x, y, double(i) / n, double(j) / n,
                                            std::uint64_t(j) * (n + 1) + i));
                    out.back().weight = weight;
                }
            }
        });
    }

private:
    const RenderScene& scene_;
    const Options& options_;
    Film film_;
    std::variant<lanes::Program, NoLanes> program_;
    tbb::enumerable_thread_specific<std::unique_ptr<Worker>> workers_;
    Statistics statistics_;
    std::mutex progress_mutex_;
};

}  // namespace

Rendered render(const RenderScene& scene, const Options& options) {
    std::optional<tbb::global_control> threads;
    if (options.threads > 0) {
        threads.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
    }
    const Stopwatch watch;
    const double cpu_start = cpu_seconds();
    Rendered result;
    result.tree = implied_tree(options);
    Renderer renderer(scene, options);
    std::visit([&](const auto& sampling) { renderer.render(sampling, result); }, options.sampling);
    result.statistics = renderer.statistics();
    result.why_general = renderer.why_general();
    const Film& film = renderer.film();
    const Region region = film.region();
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x)
            result.statistics.samples += std::uint64_t(film.at(x, y).samples);
    }
    result.picture = film.develop(options.layers);
    if (const auto& space = scene.source.settings.working_space; !space.is_linear()) {
        for (float& value : result.picture.rgb) value = float(space.to_light(double(value)));
    }
    result.interrupted = renderer.interrupted();
    result.seconds = watch.seconds();
    result.cpu_seconds = cpu_seconds() - cpu_start;
    return result;
}

}  // namespace meniscus::tracer
