#include <fmt/format.h>

#include "compare/markup.hpp"
#include "compare/page.hpp"
#include "compare/sweep.hpp"

namespace meniscus::compare {
namespace {

std::string figure(const std::optional<Metrics>& metrics) {
    return metrics ? fmt::format("{:.2e} ({:.2f} %)", metrics->rmse, 100.0 * metrics->share_off())
                   : "no picture";
}

std::string table(const Sweep& sweep) {
    Table table{
        "RMSE in linear light over red, green and blue, and the share of pixels off; CPU seconds "
        "of the trace "
        "stage in one thread.",
        {"gap", "POV-Ray against the film", "POV-Ray against contact", "Meniscus against contact",
         "CPU s, POV-Ray", "CPU s, Meniscus"},
        {}};
    for (const auto& row : sweep.rows) {
        table.rows.push_back({fmt::format("{:g}", row.gap), figure(row.film), figure(row.povray),
                              figure(row.meniscus), fmt::format("{:.3f}", row.povray_seconds),
                              fmt::format("{:.3f}", row.meniscus_seconds)});
        if (!row.failure.empty()) table.rows.push_back({"", escape(row.failure)});
        for (const auto& warning : row.warnings)
            table.rows.push_back({"", "warning: " + escape(warning)});
    }
    return format_table(table);
}

}  // namespace

std::string format_page(const Sweep& sweep, const std::string& command) {
    std::string body = fmt::format("<h1>{}</h1>\n", escape(sweep.title));
    body +=
        "<p><em>The film</em> is our picture of the same film of air, <em>contact</em> ours of the "
        "scene without a gap. "
        "Where the first column is small, POV-Ray renders its film; where the second is large, a "
        "film is not "
        "what was meant.</p>\n";
    body += "<figure>" + draw(make_plot(sweep)) + "</figure>\n";
    body += table(sweep);
    body += fmt::format("<h2>Again</h2>\n<pre><code>{}</code></pre>\n", escape(command));
    return format_page(Page{sweep.title, "", std::move(body), ""});
}

}  // namespace meniscus::compare
