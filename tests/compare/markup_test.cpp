#include "compare/markup.hpp"

#include <catch2/catch.hpp>

#include "compare/page.hpp"

using namespace meniscus::compare;

TEST_CASE("base64 as in RFC 4648, section 10", "[compare]") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xff\xfe") == "//4=");
}

TEST_CASE("text cannot become markup", "[compare]") {
    CHECK(escape("a<b> & \"c\"") == "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST_CASE("placeholders are filled, each time, and a missing value is an error", "[compare]") {
    CHECK(fill("{{a}}-{{b}}-{{a}}", {{"a", "1"}, {"b", "{{a}}"}}) == "1-{{a}}-1");
    CHECK_THROWS(fill("{{c}}", {{"a", "1"}}));
}
