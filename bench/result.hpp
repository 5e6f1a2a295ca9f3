#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/contender.hpp"
#include "bench/envelope.hpp"
#include "bench/reference.hpp"
#include "compare/metrics.hpp"
#include "tracer/statistics.hpp"

namespace meniscus::bench {

/// 0 of none.
double median(std::vector<double> values);

/// What one contender did.
struct Row {
    Contender contender;
    compare::Metrics error;                 // against the reference of its model
    std::vector<double> seconds;            // CPU, of the render stage, round by round
    tracer::Statistics counts;              // of Meniscus alone
    std::string kernel;                     // "lanes", or "general: " and why
    std::optional<double> estimated_error;  // --aa: what the renderer itself says
    bool is_on_front = false;               // no other of its curve beats it in time and error
    std::string failure;                    // why there is no picture

    double median_seconds() const;
    double nanoseconds_a_segment() const;
    Reach reach() const { return {median_seconds(), error.rmse}; }
};

/// Run time against error of one scene.
struct Result {
    std::string scene;
    int width = 0, height = 0, threads = 1;
    bool is_clipped = false;  // all pictures to [0, 1], as POV-Ray's are
    double gap = 0.0;         // scene units, of the gap model
    std::map<Model, Reference> references;
    std::vector<Row> rows;
    bool is_interrupted = false;

    /// The names of the curves as they come in the rows.
    std::vector<std::string> curves() const;
    std::vector<Reach> front(const std::string& curve) const;
};

/// Says which rows are on the front of their curve.
void mark_fronts(Result& result);

}  // namespace meniscus::bench
