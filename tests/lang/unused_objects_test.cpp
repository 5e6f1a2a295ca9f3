#include "lang/unused_objects.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

/// Their names, each with its line and column.
std::string unused(const Interpreted& result) {
    std::string text;
    for (const auto& object : result.unused_objects)
        text += object.name + '@' + std::to_string(object.location.line) + ':' +
                std::to_string(object.location.column) + ' ';
    return text;
}
std::string unused(const std::string& scene) { return unused(interpret(scene)); }

}  // namespace

TEST_CASE("declared objects that are never used are told, in the order of the text", "[lang]") {
    CHECK(unused("#declare B = sphere { 0, 1 }\n  #declare A = box { 0, 1 }\nsphere { 0, 2 }") ==
          "B@1:10 A@2:12 ");
    CHECK(unused("#declare L = light_source { 0, 1 }") == "L@1:10 ");
    CHECK(unused("#declare T = texture { } #declare N = 1;") == "");
}

TEST_CASE("a mention that reads an object uses it", "[lang]") {
    const std::string ball = "#declare B = sphere { 0, 1 } ";
    CHECK(unused(ball + "object { B }") == "");
    CHECK(unused(ball + "union { object { B } box { 0, 1 } }") == "");
    CHECK(unused(ball + "#macro Put(O) object { O translate x } #end Put(B)") == "");
    CHECK(unused(ball + "#declare All = array[1] { B }") == "");
    // what a mention makes of it may be unused in turn
    CHECK(unused(ball + "#declare C = object { B scale 2 }") == "C@1:39 ");
}

TEST_CASE("a mention that does not read an object leaves it unused", "[lang]") {
    const std::string ball = "#declare B = sphere { 0, 1 } ";
    CHECK(unused(ball + "#ifdef (B) sphere { 0, 2 } #end") == "B@1:10 ");
    CHECK(unused(ball + "#if (no) object { B } #end") == "B@1:10 ");
    CHECK(unused(ball + "#macro Never() object { B } #end") == "B@1:10 ");
    CHECK(unused(ball + "#undef B") == "B@1:10 ");
}

TEST_CASE("a declaration of which one object is used counts as used", "[lang]") {
    CHECK(unused(
              "#for (I, 0, 3) #declare B = sphere { I*x, 1 } #if (I = 2) object { B } #end #end") ==
          "");
    // of two declarations of one name, each stands for itself
    CHECK(unused("#declare B = sphere { 0, 1 }\n#declare B = box { 0, 1 }\nobject { B }") ==
          "B@1:10 ");
}

TEST_CASE("what an include declares need not be used", "[lang]") {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("meniscus_unused_objects_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "shelf.inc") << "#declare Cup = sphere { 0, 1 }";
    std::ofstream(folder / "main.scene")
        << "#include \"shelf.inc\"\n#declare Mine = sphere { 0, 1 }";
    CHECK(unused(interpret_file(folder / "main.scene")) == "Mine@2:10 ");
    std::filesystem::remove_all(folder);
}

}  // namespace meniscus::lang::test
