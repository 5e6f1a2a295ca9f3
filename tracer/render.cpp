#include "tracer/render.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "tracer/adaptive.hpp"
#include "tracer/contrast.hpp"
#include "tracer/film_passes.hpp"
#include "tracer/pixel_samples.hpp"

namespace meniscus::tracer {
namespace {

constexpr int most_samples = 1 << 16;

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

/// Decides which samples a picture is made of: a way for each kind of sampling.
class Sampler {
public:
    Sampler(FilmPasses& passes, const Options& options)
        : passes_(passes), options_(options), points_(options) {}

    void render(const GridSampling& sampling, Rendered&) {
        passes_.run(0.0, 1.0, [&](int x, int y, std::vector<Sample>& out) {
            points_.add_grid(x, y, sampling.k, out);
        });
    }

    void render(const CountSampling& sampling, Rendered& result) {
        if (sampling.samples == 1) return render(GridSampling{1}, result);
        passes_.run(0.0, 1.0, [&](int x, int y, std::vector<Sample>& out) {
            add_points(x, y, sampling.samples, out);
        });
    }

    /// Doubles the samples where that is worth most, until the picture's estimated error is small
    /// enough. The two halves of a pixel's samples are of two sets that know nothing of each other:
    /// then the difference of their means tells the error of the mean of both, neither more nor
    /// less. (Halves of one set keep out of each other's way, and differ far more.)
    void render(const ErrorSampling& sampling, Rendered& result) {
        // Of each set. A first look by few may miss what is rare: coarse pictures only.
        const int first_samples = sampling.error < 0.02 ? 8 : 4;
        const auto pixel_count = double(film().width()) * film().height();
        const double allowed = sampling.error * sampling.error * pixel_count;
        passes_.run(0.0, 0.3, [&](int x, int y, std::vector<Sample>& out) {
            add_points(x, y, first_samples, out, true);
        });
        double share = 0.3;
        while (!passes_.interrupted()) {
            const std::vector<PixelNeed> needs = pixel_needs();
            double sum = 0.0;
            for (const PixelNeed& need : needs) sum += need.squared_error;
            result.estimated_error = std::sqrt(sum / pixel_count);
            if (sum <= allowed) break;
            const std::vector<bool> chosen = choose_pixels(needs, allowed);
            if (std::ranges::find(chosen, true) == chosen.end()) break;
            const double next_share = share + 0.5 * (1.0 - share);
            passes_.run(share, next_share, [&](int x, int y, std::vector<Sample>& out) {
                const Region region = film().region();
                const auto i = std::size_t(y - region.y0) * film().width() + (x - region.x0);
                if (chosen[i]) add_points(x, y, 2 * film().tally(x, y).samples, out, true);
            });
            share = next_share;
        }
    }

    std::vector<PixelNeed> pixel_needs() const {
        std::vector<PixelNeed> needs;
        const std::vector<double> errors = film().squared_errors();
        needs.reserve(errors.size());
        const Region region = film().region();
        for (int y = region.y0; y < region.y1; ++y)
            for (int x = region.x0; x < region.x1; ++x)
                needs.push_back(
                    {errors[needs.size()],
                     std::max(film().tally(x, y).cost, double(film().tally(x, y).samples)),
                     film().tally(x, y).samples < most_samples});
        return needs;
    }

    /// Whole rounds over all pixels while there is time for one more; the count that was reached
    /// makes the same picture again.
    void render(const TimeSampling& sampling, Rendered& result) {
        const Stopwatch watch;
        int samples = 0;
        for (int next = 2; !passes_.interrupted(); next = samples + std::max(1, samples / 2)) {
            const double before = watch.seconds();
            passes_.run(
                std::min(1.0, before / sampling.seconds), std::min(1.0, before / sampling.seconds),
                [&](int x, int y, std::vector<Sample>& out) { add_points(x, y, next, out); });
            const double per_sample = (watch.seconds() - before) / (next - samples);
            samples = next;
            if (watch.seconds() + per_sample >= sampling.seconds || samples >= (1 << 20)) break;
            const int affordable = int((sampling.seconds - watch.seconds()) / per_sample);
            if (affordable < std::max(1, samples / 2)) {
                passes_.run(1.0, 1.0, [&](int x, int y, std::vector<Sample>& out) {
                    add_points(x, y, samples + affordable, out);
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
        passes_.run(0.0, 0.5, [&](int x, int y, std::vector<Sample>& out) {
            points_.add_grid(x, y, 1, out);
        });
        const std::vector<bool> marked = contrasting_pixels(film(), sampling.threshold);
        passes_.run(0.5, 1.0, [&](int x, int y, std::vector<Sample>& out) {
            if (!marked[film().index(x, y)]) return;
            if (sampling.method == 1) return points_.add_grid(x, y, sampling.depth, out);
            // Method 2 begins anew, at its full depth.
            passes_.film().clear(film().index(x, y));
            points_.add_trapezoid(x, y, 1 << (sampling.depth - 1), out);
        });
    }

private:
    const Film& film() const { return passes_.film(); }
    /// Goes on until the pixel has `count` samples.
    void add_points(int x, int y, int count, std::vector<Sample>& out,
                    bool in_two_sets = false) const {
        points_.add_points(x, y, film().tally(x, y).samples, count, out, in_two_sets);
    }

    FilmPasses& passes_;
    const Options& options_;
    PixelSamples points_;
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
    FilmPasses passes(scene, options);
    Sampler sampler(passes, options);
    std::visit([&](const auto& sampling) { sampler.render(sampling, result); }, options.sampling);
    result.statistics = passes.statistics();
    result.why_general = passes.why_general();
    const Film& film = passes.film();
    result.statistics.samples = film.samples();
    result.picture = film.develop(options.layers);
    if (const auto& space = scene.source.settings.working_space; !space.is_linear()) {
        for (float& value : result.picture.rgb) value = float(space.to_light(double(value)));
    }
    result.interrupted = passes.interrupted();
    result.seconds = watch.seconds();
    result.cpu_seconds = cpu_seconds() - cpu_start;
    return result;
}

}  // namespace meniscus::tracer
