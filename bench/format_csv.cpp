#include <fmt/format.h>

#include <algorithm>

#include "bench/format.hpp"

namespace meniscus::bench {
namespace {

/// A cell as RFC 4180 has it.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

std::string counts(const Row& row) {
    if (row.contender.is_povray()) return ",,,,,,,,,,";
    const auto& n = row.counts;
    return fmt::format("{},{},{},{},{},{},{},{},{},{:.4g},{}", n.samples, n.camera_rays,
                       n.reflected_rays, n.refracted_rays, n.shadow_rays, n.casts, n.segments,
                       n.true_crossings, n.false_crossings, row.nanoseconds_a_segment(),
                       cell(row.kernel));
}

}  // namespace

std::string format_csv(const std::vector<Report>& reports) {
    std::string text =
        "scene,width,height,threads,curve,options,on_front,rmse,bias,reference_rmse,"
        "estimated_error,cpu_seconds,least_seconds,largest_seconds,runs,samples,camera_rays,"
        "reflected_rays,refracted_rays,shadow_rays,casts,segments,true_crossings,false_crossings,"
        "ns_a_segment,kernel\n";
    for (const auto& [result, at_equal_error, of_equal_tasks] : reports) {
        for (const auto& row : result.rows) {
            if (!row.failure.empty()) continue;
            const auto [least, largest] = std::ranges::minmax(row.seconds);
            text += fmt::format(
                "{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{},{:.6g},{:.6g},{:.6g},{},{}\n",
                cell(result.scene), result.width, result.height, result.threads,
                cell(row.contender.curve), cell(row.contender.options), int(row.is_on_front),
                row.error.rmse, row.error.bias, result.references.at(row.contender.model).rmse,
                row.estimated_error ? fmt::format("{:.6g}", *row.estimated_error) : "",
                row.median_seconds(), least, largest, row.seconds.size(), counts(row));
        }
    }
    return text;
}

}  // namespace meniscus::bench
