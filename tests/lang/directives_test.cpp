#include <catch2/catch.hpp>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {
namespace {

/// What a scene prints with #debug.
std::string run(const std::string& text) { return interpret("#version 3.7;\n" + text).messages; }

const std::string show = "#macro P(V) #debug concat(str(V,0,0), \" \") #end\n";

}  // namespace

TEST_CASE("#if takes the first branch that holds", "[lang]") {
    const auto branch = [](const std::string& a) {
        return run(
            "#declare A = " + a +
            "; #if (A=1) #debug \"one\" #elseif (A=2) #debug \"two\" #else #debug \"more\" #end");
    };
    CHECK(branch("1") == "one");
    CHECK(branch("2") == "two");
    CHECK(branch("3") == "more");
    CHECK(run("# if (1) #debug \"blanks\" #\nend") == "blanks");
}

TEST_CASE("a condition may choose a block's word, as POV-Ray's includes do", "[lang]") {
    const std::string text =
        "#macro M(A) #if (A) merge { #else union { #end sphere { 0, 1 } box { 0, 1 } } #end ";
    CHECK(interpret(text + "M(0)").scene.objects.size() == 2);
    CHECK(error(text + "M(1)") == "this is POV-Ray, but not supported here: `merge`");
}

TEST_CASE("#for includes its end and leaves the next value behind", "[lang]") {
    CHECK(run(show + "#for (I, 1, 3) P(I) #end") == "1 2 3 ");
    CHECK(run(show + "#for (I, 3, 1, -1) P(I) #end P(I)") == "3 2 1 0 ");
    CHECK(run(show + "#declare N = 0; #for (I, 0, 1, 0.1) #declare N = N+1; #end P(N)") == "11 ");
    CHECK(run(show + "#for (I, 1, 10) #if (I=3) #break #end P(I) #end") == "1 2 ");
    CHECK(run(show + "#for (I, 1, 9) P(I) #declare I = I+2; #end") == "1 4 7 ");
}

TEST_CASE("#while runs while its condition holds", "[lang]") {
    CHECK(run(show + "#declare I = 0; #while (I<3) P(I) #declare I = I+1; #end") == "0 1 2 ");
    CHECK(run(show +
              "#declare I = 0; #while (1) #if (I>1) #break #end P(I) #declare I = I+1; #end") ==
          "0 1 ");
}

TEST_CASE("#case falls through to the next #break", "[lang]") {
    const auto choose = [](const std::string& v) {
        return run("#switch (" + v +
                   ") #case (1) #debug \"1\" #case (2) #debug \"2\" #break #range (3,5) #debug "
                   "\"r\" #break #else #debug \"e\" #end");
    };
    CHECK(choose("1") == "12");
    CHECK(choose("2") == "2");
    CHECK(choose("4") == "r");
    CHECK(choose("9") == "e");
}

TEST_CASE("macros", "[lang]") {
    CHECK(run(show + "#macro S(A,B) (A+B) #end P(2*S(3,4))") == "14 ");
    CHECK(run(show + "#macro Up(A) #declare A = A+1; #end #declare N = 1; Up(N) P(N)") == "2 ");
    CHECK(
        run(show + "#macro Inner() P(L) #end #macro Outer() #local L = 7; Inner() #end Outer()") ==
        "7 ");
    CHECK(run("#macro M() #local A = 1; #declare A = 2; #declare G = 3; #end M() #ifdef (A) #debug "
              "\"A\" #end #ifdef (G) #debug \"G\" #end") == "G");
    CHECK(run(show + "#macro Fact(N) #if (N<2) 1 #else (N*Fact(N-1)) #end #end P(Fact(5))") ==
          "120 ");
    CHECK(run("#macro M() #for (Q,1,3) #end #end M() #ifdef (Q) #debug \"seen\" #end") == "");
}

TEST_CASE("a macro's items stand where it is called", "[lang]") {
    const auto scene =
        interpret(
            "#version 3.7; #macro Balls(N) #for (I,1,N) sphere { I*x, 0.4 } #end #end\n"
            "#macro Red() rgb <1,0,0> #end\n"
            "union { Balls(3) pigment { Red() } }")
            .scene;
    CHECK(scene.objects.size() == 3);
    CHECK(scene.solids.size() == 1);
    CHECK(scene.textures.size() == 1);
}

TEST_CASE("declarations know where they belong", "[lang]") {
    CHECK(run("#declare A = 1; #undef A #ifndef (A) #debug \"gone\" #end") == "gone");
    CHECK(run("#ifdef (B[0]) #debug \"no\" #end #declare B = array[1] {2}; #ifdef (B[0]) #debug "
              "\"yes\" #end") == "yes");
    CHECK(run("#declare A = 1; #declare A = \"text\"; #debug A") == "text");
    CHECK(run("#debug str(defined(Nothing),0,0)") == "0");
    CHECK(run("#declare A = #if (1) 5; #else 6; #end #debug str(A,0,0)") == "5");
}

TEST_CASE("a missing semicolon is an error from version 3.5 on", "[lang]") {
    CHECK(error("#version 3.7; #declare A = 1 sphere { 0, A }") ==
          "expected ';' after the value of 'A'");
    CHECK(error("#declare A = 1 sphere { 0, A }") != "");
    const auto old = interpret("#version 3.1; #declare A = 1 sphere { 0, A }");
    CHECK(old.warnings.size() == 1);
    CHECK(error("#version 3.7; #declare A = sphere { 0, 1 } object { A }") == "");
}

TEST_CASE("messages", "[lang]") {
    CHECK(error("#error \"stop here\"") == "stop here");
    CHECK(interpret("#warning \"look\"").warnings.at(0).text == "look");
}

TEST_CASE("options declare names", "[lang]") {
    Options options;
    options.declares = {{"N", "3"}, {"T", "text"}};
    CHECK(interpret("#debug concat(T, str(N,0,0))", options).messages == "text3");
}

TEST_CASE("comments nest, and marks in strings are text", "[lang]") {
    CHECK(run("/* a /* b */ c */ // d\n#debug \"/* not // a comment */\"") ==
          "/* not // a comment */");
    CHECK(run("#debug \"x\"\r\n\t// caf\xe9\r\n") == "x");
}

TEST_CASE("errors tell how they came about", "[lang]") {
    const auto text =
        printed_error("#version 3.7;\n#macro M(A)\n  sphere { 0, A*Q }\n#end\nM(1)\n");
    CHECK(text ==
          "test.scene:3:17: error: unknown name 'Q'\n"
          "      sphere { 0, A*Q }\n"
          "                    ^\n"
          "note: in macro M called at test.scene:5:1\n");
}

}  // namespace meniscus::lang::test
