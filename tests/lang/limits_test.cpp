#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

namespace fs = std::filesystem;

std::string repeat(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

/// A folder of its own that goes with the test.
struct Folder {
    fs::path path =
        fs::temp_directory_path() / ("meniscus_lang_test_" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name, std::ios::binary) << text;
        return path / name;
    }
};

}  // namespace

TEST_CASE("nesting is bounded, whatever nests", "[lang]") {
    for (const int depth : {5000, 1000000}) {
        CAPTURE(depth);
        CHECK(error("#declare A = " + repeat("(", depth)) != "");
        CHECK(error("#declare A = " + repeat("<", depth)) != "");
        CHECK(error(repeat("union {", depth)) != "");
        CHECK(error(repeat("#if (1) ", depth)) != "");
        CHECK(error(repeat("#if (1) merge { #else union { #end ", depth)) != "");
        CHECK(error(repeat("/*", depth)) != "");
        CHECK(error(repeat("#macro M() ", depth)) != "");
        CHECK(error("#declare A = 1 + " + repeat("sin(", depth)) != "");
        CHECK(error("#declare A = (" + repeat("1 ? 1 : ", depth)) != "");
        CHECK(error("#declare F = function " + repeat("{", depth)) != "");
        CHECK(error("#declare A = array[1] " + repeat("{", depth)) != "");
    }
    CHECK(error(repeat("#if (0) merge { #else union { #end ", 100) + repeat("}", 100)) ==
          "nested too deep");
    CHECK(error("#declare A = " + repeat("(", 300) + "1" + repeat(")", 300) + ";") == "");
    CHECK(error("#declare A = " + repeat("-", 100000) + "1;") == "");
}

TEST_CASE("what grows while the scene runs is bounded", "[lang]") {
    Options options;
    options.limits.loop_steps = 10000;
    options.limits.objects = 1000;
    options.limits.string_bytes = 1000;
    CHECK(error("#while (1) #end", options).find("does this loop end") != std::string::npos);
    CHECK(error("#for (I, 0, 1e300) #end", options).find("does this loop end") !=
          std::string::npos);
    CHECK(error("#macro M() M() #end M()", options).find("call itself") != std::string::npos);
    CHECK(error("#macro M(A) (1+M(A)) #end #declare B = M(1);", options).find("call itself") !=
          std::string::npos);
    CHECK(error("#declare S = \"abc\" #while (1) #declare S = concat(S, S) #end", options)
              .find("too long") != std::string::npos);
    CHECK(error("#declare O = sphere { 0, 1 } #while (1) #declare O = union { object { O } } #end",
                options)
              .find("too deep") != std::string::npos);
    CHECK(error("#declare O = sphere { 0, 1 } #for (I,1,20) #declare O = union { object { O } "
                "object { O } } #end object { O }",
                options)
              .find("more than 1000 objects") != std::string::npos);
    CHECK(error("#declare A = array[1] {1} #while (1) #declare A = array[1] {A} #end", options)
              .find("too deep") != std::string::npos);
    CHECK(error("#declare A = array[1e9];", options).find("cannot be made") != std::string::npos);
    CHECK(error("#declare A = array[1e5][1e5];", options).find("too large") != std::string::npos);
}

TEST_CASE("files that include themselves or each other end in an error", "[lang]") {
    const Folder folder;
    const auto self = folder.write("self.scene", "#include \"self.scene\"\n");
    folder.write("a.inc", "#include \"b.inc\"\n");
    folder.write("b.inc", "#include \"a.inc\"\n");
    const auto pair = folder.write("pair.scene", "#include \"a.inc\"\n");
    for (const auto& path : {self, pair}) {
        CAPTURE(path);
        CHECK_THROWS_WITH(interpret_file(path), Catch::Contains("include itself"));
    }
}

TEST_CASE("files that cannot be read are errors of their own kind", "[lang]") {
    const Folder folder;
    CHECK_THROWS_AS(interpret_file(folder.path / "none.scene"), FileError);
    CHECK_THROWS_AS(interpret_file(folder.path), FileError);
    CHECK_THROWS_AS(interpret("#include \"none.inc\""), FileError);
    CHECK_THROWS_AS(interpret("mesh { file \"none.obj\" }"), FileError);
    const auto corrupt = folder.write("corrupt.scene", "mesh { file \"corrupt.obj\" }");
    folder.write("corrupt.obj", std::string("f 1 2 3\nv x y z\0\xff", 18));
    CHECK_THROWS_AS(interpret_file(corrupt), SourceError);
    Options tiny;
    tiny.limits.file_bytes = 10;
    CHECK_THROWS_AS(interpret_file(corrupt, tiny), FileError);
}

TEST_CASE("a mesh is read from a file beside the scene", "[lang]") {
    const Folder folder;
    folder.write("shape.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const auto scene =
        interpret_file(
            folder.write("mesh.scene",
                         "#version 3.7; mesh { file \"shape.obj\" material { ior 1.5 } }"))
            .scene;
    CHECK(std::get<geom::Mesh>(scene.objects.at(0).shape).is_closed());
}

TEST_CASE("a mesh file that no object uses is never loaded, one that many use once", "[lang]") {
    const Folder folder;
    folder.write("corrupt.obj", std::string("f 1 2 3\nv x y z\0\xff", 18));
    folder.write("shape.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const auto scene =
        interpret_file(
            folder.write("unused.scene",
                         "#version 3.7;\n#declare Spare = mesh { file \"corrupt.obj\" }\n"
                         "mesh { file \"shape.obj\" } mesh { file \"shape.obj\" }"))
            .scene;
    REQUIRE(scene.objects.size() == 2);
    CHECK(std::get<geom::Mesh>(scene.objects[0].shape).triangles ==
          std::get<geom::Mesh>(scene.objects[1].shape).triangles);

    const auto used = folder.write(
        "used.scene", "#declare Spare = mesh { file \"corrupt.obj\" }\nobject { Spare }");
    try {
        interpret_file(used);
        FAIL("no error");
    } catch (const SourceError& error) {
        CHECK(error.primary().location.line == 1);
        CHECK(error.notes().at(0).text.ends_with("used.scene:2:1"));
    }
}

TEST_CASE("a mesh file that means nothing sound says why", "[lang]") {
    const auto [text, extension, why] = GENERATE(table<std::string, std::string, std::string>({
        {"v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", "obj", "fewer than three coordinates: v 0 0"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", "obj", "impossible number"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "obj", "uses vertex 9, but it has 3"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nelement "
         "face 1\nproperty list uchar int vertex_indices\nend_header\n0 0\n1 0\n0 1\n3 0 1 2\n",
         "ply", "its vertices have no z"},
    }));
    const Folder folder;
    folder.write("shape." + extension, text);
    const auto scene =
        folder.write("s.scene", "#version 3.7;\nmesh { file \"shape." + extension + "\" }");
    CHECK_THROWS_WITH(interpret_file(scene), Catch::Contains(why));
}

TEST_CASE("an unclosed comment is shown where it opens", "[lang]") {
    const Folder folder;
    const auto [text, opens] = GENERATE(table<std::string, std::string>({
        {"sphere { 0, 1 } // no /* here\n  /* one\n", ":2:3"},
        {"#debug \"/*\"\nbox { 0, 1 /* a /* b */\n", ":2:12"},
        {"/* a */ /* b\n /* c\n", ":2:2"},
    }));
    try {
        interpret_file(folder.write("s.scene", text));
        FAIL("no error");
    } catch (const SourceError& e) {
        CHECK_THAT(e.primary().text, Catch::Contains("to end this comment"));
        REQUIRE(e.notes().size() == 1);
        CHECK_THAT(e.notes()[0].text, Catch::EndsWith("s.scene" + opens));
    }
}

TEST_CASE("includes carry their folder, their place in errors and their locals", "[lang]") {
    const Folder folder;
    folder.write("part.inc", "#local Hidden = 1; #declare Shown = 2;\nsphere { 0, 1 }\n");
    const auto good = folder.write("good.scene",
                                   "#version 3.7;\nunion { #include \"part.inc\" }\n#ifdef "
                                   "(Hidden) #error \"leaked\" #end #debug str(Shown,0,0)");
    CHECK(interpret_file(good).messages == "2");
    folder.write("bad.inc", "\n  sphare { 0, 1 }");
    const auto bad = folder.write("bad.scene", "#include \"bad.inc\"");
    try {
        interpret_file(bad);
        FAIL("no error");
    } catch (const SourceError& e) {
        CHECK(e.primary().location.line == 2);
        CHECK(e.primary().location.column == 3);
        REQUIRE(e.notes().size() == 1);
        CHECK(e.notes()[0].text == "included at " + bad.string() + ":1:10");
    }
}

TEST_CASE("bytes that mean nothing are errors", "[lang]") {
    CHECK(error(std::string("sphere { 0, \0 1 }", 17)) != "");
    CHECK(error("\xff\xfe") != "");
    CHECK(error("\xEF\xBB\xBF#version 3.7;") == "");
    CHECK(error("") == "");
    CHECK(error("\x1a") == "");
}

}  // namespace meniscus::lang::test
