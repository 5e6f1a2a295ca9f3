#include "compare/report.hpp"

#include <catch2/catch.hpp>

#include "compare/pixel_data.hpp"
#include "tests/compare/pictures.hpp"

using namespace meniscus;
using Catch::Contains;

namespace {

std::string report(const std::string& title) {
    const auto comparison = test::two_differences();
    return compare::format_report(comparison,
                                  {.title = title,
                                   .settings = {{"size", "8 x 4"}},
                                   .commands = {{"Again:", "meniscus compare 'a b.png' c.png"}},
                                   .explanations = {{5,
                                                     1,
                                                     {{"Ours", "the tree of <5, 1>", "<svg/>"},
                                                      {"Theirs", "theirs", "<svg/>"}},
                                                     {{"Alone:", "povray +SC6"}}}},
                                   .tolerance = 1e-3});
}

}  // namespace

TEST_CASE("a report needs no other file and no network", "[compare]") {
    const auto html = report("A title");
    for (const auto* reference : {"src=\"http", "href=\"http", "src=\"//", "@import", "url("})
        CHECK_THAT(html, !Contains(reference));
    CHECK_THAT(html, Contains("data:image/png;base64,"));
}

TEST_CASE("a report holds the numbers, the commands and the worst pixels' ray trees", "[compare]") {
    const auto html = report("A title");
    CHECK_THAT(html, Contains("<title>A title</title>") && Contains("Above the tolerance"));
    CHECK_THAT(html, Contains("meniscus compare 'a b.png' c.png") && Contains("8 x 4"));
    CHECK_THAT(html, Contains("href=\"#pixel-5-1\"") && Contains("id=\"pixel-5-1\""));
    CHECK_THAT(html, Contains("the tree of &lt;5, 1&gt;") && Contains("povray +SC6"));
    CHECK_THAT(html, Contains("<h3>Ours</h3>") && Contains("<h3>Theirs</h3>"));
    CHECK_THAT(html, Contains("id=\"pixel-2-3\""));
}

TEST_CASE("names cannot break out of a report", "[compare]") {
    const auto html = report("</script><b>");
    CHECK_THAT(html, !Contains("</script><b>"));
}

TEST_CASE("values of a picture beside its equal take little room", "[compare]") {
    image::Image a(64, 64);
    for (std::size_t i = 0; i < a.rgb.size(); ++i) a.rgb[i] = float(i % 977) / 977.0f;
    auto other = a;
    for (float& v : other.rgb) v = 1.0f - v * v;
    CHECK(2 * compare::pack(a, a).size() < 3 * compare::pack(a, other).size());
}
