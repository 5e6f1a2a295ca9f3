#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "tracer/film.hpp"
#include "tracer/lane_host.hpp"
#include "tracer/lane_program.hpp"
#include "tracer/samples.hpp"

namespace meniscus::tracer {

/// Passes over the film, tile by tile on all cores, in lanes where the scene allows it. A pixel
/// belongs to one tile, so no result depends on threads.
class FilmPasses {
public:
    FilmPasses(const RenderScene& scene, const Options& options);
    ~FilmPasses();

    /// Adds the samples that pixel (x, y) is to have in a pass, each with a number of its own.
    using Plan = std::function<void(int x, int y, std::vector<Sample>& out)>;
    /// Follows what the plan wants of each pixel. The finished share goes from `from` to `to`.
    void run(double from, double to, const Plan& plan);

    Film& film() { return film_; }
    const Film& film() const { return film_; }
    const Statistics& statistics() const { return statistics_; }
    bool interrupted() const { return options_.interrupted && options_.interrupted->load(); }
    /// Why rays go one at a time; empty: they go in lanes.
    std::string why_general() const;

private:
    struct Worker;
    struct Target;
    void report(double share);
    void follow_singly(Worker& worker, const Region& window, const Plan& plan);
    void follow_in_lanes(Worker& worker, const Region& window, const Plan& plan);
    void share_out(Worker& worker, std::span<Sample> samples, std::size_t pixel);
    void empty_into_film(Worker& worker);

    const RenderScene& scene_;
    const Options& options_;
    Film film_;
    std::variant<lanes::Program, NoLanes> program_;
    tbb::enumerable_thread_specific<std::unique_ptr<Worker>> workers_;
    Statistics statistics_;
    std::mutex progress_mutex_;
};

}  // namespace meniscus::tracer
