#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/ratios.hpp"
#include "bench/result.hpp"
#include "compare/plot.hpp"

namespace meniscus::bench {

/// A result with what is read off it.
struct Report {
    Result result;
    std::vector<Ratio> at_equal_error, of_equal_tasks;
};

/// `errors` as of ratios_at_equal_error().
Report make_report(Result result, const std::vector<double>& errors);

/// Tables for people.
std::string format_text(const Report& report);

/// All rows of all scenes below one line of names; what a renderer does not tell is left empty.
std::string format_csv(const std::vector<Report>& reports);

nlohmann::ordered_json to_json(const Report& report);

/// Seconds to the right, error up: each curve's points and its front.
compare::Plot make_plot(const Result& result);

/// An HTML page of one file. `command` is what makes it again.
std::string format_page(const std::vector<Report>& reports, const std::string& command);

}  // namespace meniscus::bench
