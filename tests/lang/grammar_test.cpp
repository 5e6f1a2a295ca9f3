#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <tao/pegtl/contrib/analyze.hpp>

#include "grammar/scene_grammar.hpp"
#include "lang/parse.hpp"

namespace tao::pegtl {

template <class Name, meniscus::grammar::WordClass... Classes>
struct analyze_traits<Name, meniscus::grammar::word_of<Classes...>> : analyze_any_traits<> {};

}  // namespace tao::pegtl

namespace meniscus::lang::test {
namespace {

std::string read(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::set<std::string> all;
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i)
        all.insert((*i)[1]);
    return all;
}

ast::Program parse_text(const std::string& text) {
    static std::vector<std::unique_ptr<Source>> kept;
    kept.push_back(std::make_unique<Source>("text", text));
    return parse(*kept.back());
}

}  // namespace

TEST_CASE("no rule of the grammar loops without progress", "[lang]") {
    CHECK(tao::pegtl::analyze<grammar::file>() == 0);
}

TEST_CASE("grammar/README.md names every rule and no other", "[lang]") {
    const std::string folder = MENISCUS_GRAMMAR_FOLDER;
    const auto code =
        matches(read(folder + "/scene_grammar.hpp"), std::regex("\\nstruct (\\w+)\\s*:"));
    const auto page = matches(read(folder + "/README.md"), std::regex("\\n    (\\w+)\\s*<-"));
    for (const auto& rule : code) {
        CAPTURE(rule);
        CHECK(page.contains(rule));
    }
    for (const auto& rule : page) {
        CAPTURE(rule);
        CHECK(code.contains(rule));
    }
}

TEST_CASE("a block is a list of items", "[lang]") {
    const auto program =
        parse_text("sphere { <0, 1, 2>, 3 hollow [0.5 x] pigment { rgb 1 } #if (1) y #end }");
    REQUIRE(program.items.size() == 1);
    const auto& block = std::get<ast::Block>(program.items[0].node);
    CHECK(block.word == "sphere");
    CHECK(block.items.size() == 7);
    CHECK(std::holds_alternative<ast::Expression>(block.items[0].node));
    CHECK(std::holds_alternative<ast::Separator>(block.items[1].node));
    CHECK(std::holds_alternative<ast::Word>(block.items[3].node));
    CHECK(std::holds_alternative<ast::MapEntry>(block.items[4].node));
    CHECK(std::holds_alternative<ast::Block>(block.items[5].node));
    CHECK(std::holds_alternative<std::unique_ptr<ast::If>>(block.items[6].node));
}

TEST_CASE("spans end where the text ends, not behind blanks", "[lang]") {
    const auto program = parse_text("scale  A * 2   ");
    CHECK(program.items[1].span.text() == "A * 2");
}

TEST_CASE("a macro's body is kept as text", "[lang]") {
    const auto program =
        parse_text("#macro M(A) sphere { #if (1) \"#end\" /* #end */ #end #end box");
    const auto& macro = *std::get<std::unique_ptr<ast::Macro>>(program.items[0].node);
    CHECK(macro.name == "M");
    CHECK(macro.body.text() == "sphere { #if (1) \"#end\" /* #end */ #end");
    CHECK(program.items.size() == 2);
}

TEST_CASE("a very long sum is no deep tree", "[lang]") {
    std::string sum = "#declare A = 1";
    for (int i = 0; i < 100000; ++i) sum += "+1";
    CHECK_NOTHROW(parse_text(sum + ";"));
}

}  // namespace meniscus::lang::test
