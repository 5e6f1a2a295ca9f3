#pragma once

#include <string>
#include <vector>

#include "bench/result.hpp"

namespace test {

/// A row of a curve, with an error and the seconds of its runs.
inline meniscus::bench::Row row(const std::string& curve, double error, std::vector<double> seconds,
                                const std::string& options = "x") {
    using namespace meniscus::bench;
    Row row;
    row.contender.curve = curve;
    row.contender.options = options;
    if (curve.find("gap") != curve.npos) row.contender.model = Model::gap;
    if (curve.starts_with("POV-Ray")) row.contender.how = ByPovRay{};
    row.error.rmse = error;
    row.seconds = std::move(seconds);
    return row;
}

/// References without an error of their own.
inline meniscus::bench::Result result(std::vector<meniscus::bench::Row> rows) {
    using namespace meniscus::bench;
    Result result;
    result.scene = "glass.scene";
    result.width = 4;
    result.height = 3;
    result.references[Model::contact];
    result.references[Model::gap];
    result.rows = std::move(rows);
    return result;
}

}  // namespace test
