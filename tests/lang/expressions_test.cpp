#include <catch2/catch.hpp>

#include "tests/lang/helper.hpp"

namespace meniscus::lang::test {

TEST_CASE("numbers are what the table says", "[lang]") {
    struct Case {
        const char* expression;
        double value;
    };
    const Case cases[] = {
        // spelling
        {"1", 1},
        {"1.", 1},
        {".5", 0.5},
        {"1e3", 1000},
        {"1.e2", 100},
        {"2E-1", 0.2},
        // precedence: unary first, then * /, then + -, then comparisons, then & and | on one level
        {"-2*3", -6},
        {"!0+1", 2},
        {"2+3*4", 14},
        {"(2+3)*4", 20},
        {"8/2/2", 2},
        {"8-2-2", 4},
        {"2*-3", -6},
        {"- -3", 3},
        {"!!5", 1},
        {"(1<2)", 1},
        {"(1+1=2)", 1},
        {"(1|0&0)", 0},
        {"(1?2:3)", 2},
        {"(0?2:1?3:4)", 3},
        {"(1<2&2<1)", 0},
        // tolerance of equality and truth; the strict comparisons have none
        {"(0.1+0.2=0.3)", 1},
        {"(1e-13?1:0)", 0},
        {"(1e-11>0)", 1},
        {"(1<1+1e-12)", 1},
        {"(1>=1+1e-12)", 1},
        {"(1!=1+1e-12)", 0},
        // functions
        {"mod(-7,3)", -1},
        {"int(-2.5)", -2},
        {"floor(-2.5)", -3},
        {"ceil(2.1)", 3},
        {"div(7,2)", 3},
        {"abs(-2)", 2},
        {"select(-1,1,2)", 1},
        {"select(0,1,2)", 2},
        {"select(0,1,2,3)", 2},
        {"select(1,1,2,3)", 3},
        {"max(1,5,3)", 5},
        {"min(4,2,3)", 2},
        {"pow(2,10)", 1024},
        {"sqrt(2)*sqrt(2)", 2},
        {"exp(0)", 1},
        {"ln(exp(2))", 2},
        {"log(1000)", 3},
        {"sin(pi/2)", 1},
        {"degrees(pi)", 180},
        {"radians(180)-pi", 0},
        {"atan2(1,1)-pi/4", 0},
        {"asin(2)-pi/2", 0},
        {"abs(1<2)", 1},
        {"bitwise_and(6,3)", 2},
        {"asc(\"A\")", 65},
        {"strlen(\"abc\")", 3},
        {"strcmp(\"b\",\"a\")", 1},
        {"strcmp(\"a\",\"c\")", -2},
        {"val(\"2.5\")", 2.5},
        // constants
        {"pi", 3.14159265358979},
        {"yes", 1},
        {"off", 0},
        {"clock", 0},
        {"image_width/image_height", 640.0 / 480.0},
        {"version", 3.7},
        // members
        {"<1,2,3>.y", 2},
        {"(x+y).x", 1},
        {"<1,2>.u", 1},
        {"(rgb <1,2,3>).green", 2},
        // vectors to numbers
        {"vlength(1)*vlength(1)", 3},
        {"vdot(<1,2,3>,<4,5,6>)", 32},
    };
    for (const auto& c : cases) {
        CAPTURE(c.expression);
        if (std::string(c.expression).find("rgb") != std::string::npos) {
            CHECK(number("C.green", "#declare C = rgb <1,2,3>;") == 2.0);
        } else {
            CHECK(number(c.expression) == Approx(c.value).margin(1e-11));
        }
    }
}

TEST_CASE("numbers and short vectors are promoted", "[lang]") {
    CHECK(vector("1-x") == "0.000,1.000,1.000");
    CHECK(vector("!x") == "0.000,1.000,1.000");
    CHECK(vector("y*z") == "0.000,0.000,0.000");
    CHECK(vector("<1,2>+<1,1,1>") == "2.000,3.000,1.000");
    CHECK(vector("<1,2,3>*<4,5,6>") == "4.000,10.000,18.000");
    CHECK(vector("u+v", 4) == "1.000,1.000,0.000,0.000");
    CHECK(vector("t", 4) == "0.000,0.000,0.000,1.000");
    CHECK(vector("-<1,2,3>") == "-1.000,-2.000,-3.000");
}

TEST_CASE("rotations turn the left-handed way", "[lang]") {
    CHECK(vector("vrotate(z, 90*y)") == "1.000,0.000,0.000");
    CHECK(vector("vrotate(x, <0,90,0>)+0.0001") == "0.000,0.000,-1.000");
    CHECK(vector("vaxis_rotate(x, z, 90)+0.0001") == "0.000,1.000,0.000");
    CHECK(vector("vcross(x, y)") == "0.000,0.000,1.000");
    CHECK(vector("vnormalize(<0,3,4>)") == "0.000,0.600,0.800");
}

TEST_CASE("colors are phrases", "[lang]") {
    CHECK(vector("C", 5, "#declare C = rgb <1,2,3>*0.5;") == "0.500,1.000,1.500,0.000,0.000");
    CHECK(vector("C", 5, "#declare C = color red 1 green 0.5 filter 0.3;") ==
          "1.000,0.500,0.000,0.300,0.000");
    CHECK(vector("C", 5, "#declare C = color rgb <.1,.2,.3> transmit 0.3;") ==
          "0.100,0.200,0.300,0.000,0.300");
    CHECK(vector("C", 5, "#declare C = rgbt 1;") == "1.000,1.000,1.000,0.000,1.000");
    CHECK(vector("C", 5, "#declare C = rgbft <1,2,3,4,5>;") == "1.000,2.000,3.000,4.000,5.000");
    CHECK(vector("C", 5, "#declare C = srgb 0.5;") == "0.214,0.214,0.214,0.000,0.000");
    CHECK(vector("0.5*R + B", 5, "#declare R = rgb x; #declare B = rgb z;") ==
          "0.500,0.000,1.000,0.000,0.000");
    CHECK(number("C.gray", "#declare C = rgb <.1,.2,.3>;") ==
          Approx(0.297 * .1 + 0.589 * .2 + 0.114 * .3));
}

TEST_CASE("strings", "[lang]") {
    CHECK(debug("", "str(5, 0, -1)") == "5.000000");
    CHECK(debug("", "str(5, -6, 2)") == "005.00");
    CHECK(debug("", "str(5, 6, 2)") == "  5.00");
    CHECK(debug("", "concat(\"a\", str(1,0,0), \"b\")") == "a1b");
    CHECK(debug("", "substr(\"abcdef\", 2, 3)") == "bcd");
    CHECK(debug("", "concat(strupr(\"ab\"), strlwr(\"CD\"), chr(65))") == "ABcdA");
    CHECK(debug("", "vstr(3, <1,2,3>, \"; \", 0, 1)") == "1.0; 2.0; 3.0");
    CHECK(debug("", R"("a\"b\\c\n")") == "a\"b\\c\n");
    CHECK(debug("", R"("\u0041")") == "A");
    CHECK(number("(\"a\"=\"a\")") == 1.0);
}

TEST_CASE("random numbers are POV-Ray's", "[lang]") {
    const std::string seed = "#declare S = seed(1); #declare T = S;";
    CHECK(
        debug(seed, "concat(str(rand(S),0,9), \" \", str(rand(T),0,9), \" \", str(rand(S),0,9))") ==
        "0.421992875 0.487121198 0.665896216");
}

TEST_CASE("vectors need few commas", "[lang]") {
    CHECK(vector("<1 2 3>") == "1.000,2.000,3.000");
    CHECK(vector("<1, 2, 3,>") == "1.000,2.000,3.000");
    CHECK(vector("<1 -2 3>", 2) == "-1.000,3.000");
    CHECK(error("#declare V = <1,,2>;") != "");
}

TEST_CASE("arrays", "[lang]") {
    const std::string grid = "#declare A = array[2][2] {{1,2},{3,4}};";
    CHECK(number("A[1][0]", grid) == 3.0);
    CHECK(number("A[1.9][0.2]", grid) == 3.0);
    CHECK(number("dimensions(A)", grid) == 2.0);
    CHECK(number("dimension_size(A, 2)", grid) == 2.0);
    CHECK(number("B[0][0]+A[0][0]", grid + "#declare B = A; #declare A[0][0] = 9;") == 10.0);
    CHECK(number("A[2]", "#declare A = array[3]; #declare A[2] = 5;") == 5.0);
    CHECK(vector("A[1]", 3, "#declare A = array[2] {<1,2,3> <4,5,6>}") == "4.000,5.000,6.000");
}

TEST_CASE("divisions by zero warn", "[lang]") {
    const auto result = interpret("#version 3.7; #declare A = 1/0;");
    REQUIRE(result.warnings.size() == 1);
    CHECK(result.warnings[0].text == "division by zero");
    CHECK(result.warnings[0].location.column == 28);
}

}  // namespace meniscus::lang::test
