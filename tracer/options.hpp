#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "tracer/pixel_filter.hpp"

namespace meniscus::tracer {

/// How a ray knows which solids it is inside of.
enum class InteriorMode {
    sweep,   // one traversal a segment, coincident crossings as one event
    recast,  // Schmidt and Budge 2002: toggle at each hit, cast again behind false ones
    off      // an ordinary tracer: each surface bounds its own solid against the outside
};

/// Which branches of the ray tree are followed.
enum class Tree {
    whitted,  // every branch, under max_trace_level and adc_bailout with POV-Ray's meaning
    full,     // every branch, to `depth` and `cutoff`
    sampled   // unbiased: both branches while the weight is high, then one by chance
};

/// Which code follows the rays. Pictures are equal to rounding.
enum class Kernel {
    automatic,  // lanes where the scene allows it
    general     // one ray at a time: any scene, any option
};

/// k x k midpoints of a pixel, box filter; k = 1 is the pixel centre.
struct GridSampling {
    int k = 1;
};
/// n points of a low-discrepancy set in each pixel.
struct CountSampling {
    int samples = 16;
};
/// Adaptive: until the picture's estimated root mean square error is below `error`.
struct ErrorSampling {
    double error = 0.01;
};
/// Until `seconds` have passed.
struct TimeSampling {
    double seconds = 10.0;
};
/// POV-Ray's +A threshold +R depth +AM method: supersample where neighbours contrast.
struct ContrastSampling {
    double threshold = 0.3;
    int depth = 3;
    int method = 1;
};
using Sampling =
    std::variant<GridSampling, CountSampling, ErrorSampling, TimeSampling, ContrastSampling>;

/// Pixels [x0, x1) x [y0, y1), from the top left.
struct Region {
    int x0, y0, x1, y1;
};

struct Options {
    int width = 640, height = 480;
    std::optional<Region> region;  // default: the whole picture
    Sampling sampling = ErrorSampling{};
    PixelFilter filter = PixelFilter::box;  // of CountSampling, ErrorSampling and TimeSampling
    std::optional<Tree>
        tree;  // default: whitted with GridSampling and ContrastSampling, else sampled
    InteriorMode interior = InteriorMode::sweep;
    Kernel kernel = Kernel::automatic;
    std::string instruction_set;   // of the lanes: lanes::instruction_sets(); empty: the best
    double recast_epsilon = 1e-9;  // recast and off: how far from its origin a ray must have come,
                                   // times the scene's size
    int depth = 100;               // full and sampled: segments of one path
    double cutoff = 1e-6;          // full: branches of lower weight are dropped
    std::uint64_t seed = 0;
    int threads = 0;      // 0: all cores
    bool layers = false;  // also make the extra image layers
    bool check_segments =
        false;  // --strict: ask at inner points of segments which solids contain them

    std::function<void(double)>
        progress;  // called with the finished share, from any thread, one call at a time
    const std::atomic<bool>* interrupted = nullptr;  // set: stop soon and keep the picture so far
};

/// The tree that the options imply.
Tree implied_tree(const Options& options);

std::string_view name(InteriorMode mode);
std::string_view name(Tree tree);

}  // namespace meniscus::tracer
