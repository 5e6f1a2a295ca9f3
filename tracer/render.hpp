#pragma once

#include <map>
#include <optional>
#include <string>

#include "image/image.hpp"
#include "tracer/options.hpp"
#include "tracer/render_scene.hpp"
#include "tracer/statistics.hpp"

namespace meniscus::tracer {

struct Rendered {
    image::Image picture;
    Statistics statistics;
    double seconds = 0.0, cpu_seconds = 0.0;  // of the render stage
    Tree tree = Tree::whitted;                // what was chosen
    std::optional<double> estimated_error;    // adaptive sampling: root mean square reached
    std::map<std::string, std::string>
        reproduce;  // options that make the same picture again ("samples": "64")
    bool interrupted = false;
    std::string why_general;  // why rays went one at a time; empty: they went in lanes
};

/// The same scene and options give the same bytes, for any number of threads.
Rendered render(const RenderScene& scene, const Options& options);

}  // namespace meniscus::tracer
