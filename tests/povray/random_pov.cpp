#include "tests/povray/random_pov.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

#include "tests/random/random.hpp"

namespace meniscus::test {
namespace {

/// Words made from random numbers.
class Writer {
public:
    explicit Writer(std::uint64_t seed) : random_(seed) {}

    std::string scene() {
        return "#version 3.7;\n" + settings() + camera() + surroundings() + lights() + objects();
    }

private:
    int below(int n) { return random_.below(n); }
    bool chance(double p) { return number(0.0, 1.0) < p; }
    /// Four digits: both readers see the same number.
    double number(double low, double high) {
        return std::round(random_.between(low, high) * 1e4) / 1e4;
    }
    std::string pick(std::initializer_list<const char*> words) {
        return *(words.begin() + below(int(words.size())));
    }
    std::string vector(double low, double high) {
        const double x = number(low, high), y = number(low, high), z = number(low, high);
        return fmt::format("<{}, {}, {}>", x, y, z);
    }
    std::string color(double high = 1.0) { return "rgb " + vector(0.05, high); }

    std::string settings() {
        return fmt::format(
            "global_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout {}{} }}\n",
            pick({"3", "5", "12", "20"}), pick({"1/255", "0.01", "1e-4", "1e-5"}),
            chance(0.2) ? " ambient_light " + color() : "");
    }

    std::string camera() {
        std::string text = "camera {";
        const bool orthographic = chance(0.25);
        if (orthographic) text += " orthographic";
        text += fmt::format(" location <{}, {}, {}>", number(-2.5, 2.5), number(1.0, 3.5),
                            number(-8.0, -5.5));
        if (chance(0.3))
            text += " sky " + fmt::format("<{}, 1, {}>", number(-0.5, 0.5), number(-0.3, 0.3));
        if (orthographic) {
            text += chance(0.5) ? " right 5.2*x up 3.9*y"
                                : " angle 34 right x*image_width/image_height";
        } else if (chance(0.7)) {
            text += fmt::format(" angle {} right {}x*image_width/image_height", number(30, 60),
                                chance(0.2) ? "-" : "");
        } else {
            text += fmt::format(" direction z*{}", number(0.9, 1.8));
        }
        text += fmt::format(" look_at <{}, {}, 0>", number(-0.3, 0.3), number(0.3, 0.9));
        if (chance(0.2))
            text += fmt::format(" translate {} rotate y*{}", vector(-0.2, 0.2), number(-20, 20));
        return text + " }\n";
    }

    std::string surroundings() {
        std::string text;
        if (chance(0.8)) text += "background { " + color() + " }\n";
        if (chance(0.5)) {
            text += "sky_sphere { pigment { gradient y color_map { [0 " + color() + "] [" +
                    pick({"0.3", "0.5"}) + " " + color() + "] [1 " + colored() +
                    "] } scale 2 translate -1 }";
            if (chance(0.3)) text += " pigment { rgbt " + transparent(0.9) + " }";
            if (chance(0.3)) text += " rotate " + vector(-90, 90);
            text += " }\n";
        }
        return text;
    }

    /// `<r, g, b, x>` for rgbf or rgbt.
    std::string transparent(double most) {
        return fmt::format("<{}, {}, {}, {}>", number(0.1, 1), number(0.1, 1), number(0.1, 1),
                           number(0.2, most));
    }
    std::string colored() {
        return transparent_ && chance(0.2) ? "rgbt " + transparent(0.9) : color();
    }

    std::string lights() {
        std::string text;
        const int count = 1 + below(3);
        for (int i = 0; i < count; ++i) {
            text += fmt::format("light_source {{ <{}, {}, {}> {}", number(-6, 6), number(2.5, 7),
                                number(-7, 1), color(count == 1 ? 1.0 : 0.6));
            // POV-Ray takes `shadowless` for a kind of light, in the place of spot and cylinder.
            const bool shadowless = chance(0.15);
            switch (shadowless ? 2 + below(4) : below(6)) {
                case 0:
                    text += fmt::format(" spotlight point_at {} radius {} falloff {}",
                                        vector(-0.5, 0.5), number(5, 20), number(15, 40));
                    if (chance(0.5)) text += fmt::format(" tightness {}", number(0, 12));
                    break;
                case 1:
                    text += fmt::format(" cylinder point_at {} radius {} falloff {}",
                                        vector(-0.5, 0.5), number(0.3, 1.5), number(1, 2.5));
                    if (chance(0.5)) text += fmt::format(" tightness {}", number(0, 4));
                    break;
                case 2:
                    text += " parallel point_at " + vector(-0.5, 0.5);
                    break;
                default:
                    break;
            }
            if (chance(0.3))
                text +=
                    fmt::format(" fade_distance {} fade_power {}", number(2, 8), number(0.5, 2.5));
            if (shadowless) text += " shadowless";
            text += " }\n";
        }
        return text;
    }

    std::string map(const std::string& entry_of) {
        const bool pigments = entry_of == "pigment_map";
        std::string text = entry_of + " {";
        double at = number(0, 0.3);
        for (int i = 0; i < 2 + below(3); ++i) {
            text += fmt::format(" [{} {}]", at, pigments && chance(0.4) ? pattern(0) : colored());
            at += chance(0.2) ? 0.0 : std::round(number(0.05, 0.4) * 1e4) / 1e4;
        }
        return text + " }";
    }

    std::string moved() {
        std::string text;
        if (chance(0.6)) text += fmt::format(" scale {}", number(0.15, 0.8));
        if (chance(0.4)) text += " rotate " + vector(-90, 90);
        if (chance(0.4)) text += " translate " + vector(-1, 1);
        if (chance(0.1))
            text +=
                fmt::format(" scale <{}, {}, {}>", number(0.5, 2), number(0.5, 2), number(0.5, 2));
        return text;
    }

    /// What stands inside of pigment { }.
    std::string pattern(int depth) {
        const bool pigments = depth > 0 && chance(0.3);  // all of a list, or none
        const auto sub = [&] {
            return pigments ? "pigment { " + pattern(depth - 1) + " }" : colored();
        };
        switch (below(5)) {
            case 0: {
                const std::string a = sub(), b = sub();
                return "checker " + a + ", " + b + moved();
            }
            case 1: {
                const std::string a = sub(), b = sub(), c = sub();
                return "hexagon " + a + ", " + b + ", " + c + moved();
            }
            case 2: {
                const std::string a = sub(), b = sub();
                std::string text = "brick " + a + ", " + b;
                if (chance(0.5))
                    text += fmt::format(" brick_size <{}, {}, {}> mortar {}", number(0.5, 3),
                                        number(0.3, 2), number(0.5, 3), number(0.05, 0.3));
                else
                    text += " scale 0.2";
                return text + moved();
            }
            case 3: {
                std::string text = "gradient " +
                                   (chance(0.5) ? pick({"x", "y", "z"}) : vector(-1, 1)) + " " +
                                   map(depth > 0 && chance(0.3) ? "pigment_map" : "color_map");
                if (chance(0.3))
                    text += " " + pick({"triangle_wave", "sine_wave", "scallop_wave", "cubic_wave",
                                        "ramp_wave", "poly_wave 2", "poly_wave 0.5"});
                if (chance(0.3)) text += fmt::format(" frequency {}", number(0.5, 4));
                if (chance(0.3)) text += fmt::format(" phase {}", number(0, 1));
                return text + moved();
            }
            default:
                return colored();
        }
    }

    std::string finish(bool fresnel) {
        std::string text = "finish {";
        if (chance(0.5)) text += fmt::format(" ambient {}", number(0, 0.4));
        if (chance(0.7)) text += fmt::format(" diffuse {}", number(0, 0.9));
        if (chance(0.2)) text += fmt::format(" brilliance {}", number(0.5, 4));
        if (chance(0.2)) text += " emission " + color(0.4);
        if (chance(0.3))
            text += fmt::format(" phong {} phong_size {}", number(0.1, 1), number(2, 60));
        if (chance(0.3))
            text += fmt::format(" specular {} roughness {}", number(0.1, 1), number(0.01, 0.2));
        if (chance(0.2)) text += fmt::format(" metallic {}", number(0, 1));
        if (chance(0.4)) {
            text += " reflection { ";
            if (chance(0.5)) text += color(0.4) + ", ";
            text += color(0.8);
            if (fresnel) text += " fresnel";
            if (!fresnel && chance(0.3)) text += fmt::format(" falloff {}", number(0.5, 4));
            if (chance(0.2)) text += fmt::format(" exponent {}", number(0.5, 2));
            if (chance(0.2)) text += fmt::format(" metallic {}", number(0, 1));
            text += " }";
            if (chance(0.4)) text += " conserve_energy";
        }
        return text + " }";
    }

    std::string clear_or_tinted_glass() {
        std::string text = "texture { pigment { ";
        text += chance(0.5) ? "rgbt 1" : (chance(0.5) ? "rgbf " : "rgbt ") + transparent(1.0);
        text += " } finish { ambient 0 diffuse " + pick({"0", "0", "0.2"});
        const bool reflects = chance(0.5);
        if (reflects) text += " reflection { 1 fresnel } conserve_energy";
        text += " } }";
        text += fmt::format(" interior {{ ior {}", number(1.0, 2.2));
        // Of what a medium reflects, POV-Ray forgets the fading.
        if (!reflects && chance(0.4))
            text += fmt::format(" fade_distance {} fade_power {} fade_color {}", number(0.2, 2),
                                pick({"1", "2", "1000", "1001"}), color());
        return text + " }";
    }

    /// Without an ior: a body of it is a bubble of air in the air. Where it reflects by Fresnel it
    /// has one, and no holes.
    std::string opaque_texture() {
        const bool fresnel = chance(0.2);
        transparent_ = !fresnel;
        std::string text = "texture { pigment { " + pattern(1) + " } " + finish(fresnel);
        if (chance(0.3)) text += moved();
        transparent_ = true;
        return text + (fresnel ? " } interior { ior 1.5 }" : " }");
    }

    /// About the origin, no farther than 0.5 from it.
    std::string shape(bool solid) {
        switch (below(solid ? 7 : 12)) {
            case 0:
                return fmt::format("sphere {{ {}, {}", vector(-0.1, 0.1), number(0.2, 0.4));
            case 1:
                return fmt::format("box {{ {}, {}", vector(-0.3, -0.1), vector(0.1, 0.3));
            case 2:
                return fmt::format("cylinder {{ {}, {}, {}{}", vector(-0.25, -0.1),
                                   vector(0.1, 0.25), number(0.08, 0.2),
                                   !solid && chance(0.4) ? " open" : "");
            case 3:
                return fmt::format("cone {{ {}, {}, {}, {}{}", vector(-0.25, -0.1),
                                   number(0.1, 0.25), vector(0.1, 0.25), number(0, 0.1),
                                   !solid && chance(0.4) ? " open" : "");
            case 4:
                return fmt::format("torus {{ {}, {}", number(0.2, 0.3), number(0.05, 0.15));
            case 5:
                return fmt::format("sphere {{ 0, 0.4 scale <{}, {}, {}> rotate {}", number(0.4, 1),
                                   number(0.4, 1), number(0.4, 1), vector(-90, 90));
            case 6:
                return fmt::format(
                    "lathe {{ {} <0, -0.4>, <{}, -0.35>, <{}, 0>, <{}, 0.3>, <0, 0.4>",
                    "linear_spline 5", number(0.1, 0.3), number(0.1, 0.3), number(0.1, 0.3));
            case 7:
                return fmt::format("disc {{ 0, {}, {}, {}", vector(-1, 1), number(0.3, 0.45),
                                   number(0, 0.2));
            case 8: {
                const std::string a = vector(-0.4, 0), b = vector(0, 0.4);
                return fmt::format("triangle {{ {}, {}, <{}, {}, 0>", a, b, number(-0.4, 0),
                                   number(0.1, 0.4));
            }
            case 9:
                return fmt::format(
                    "smooth_triangle {{ <-0.4, -0.3, 0>, <-0.4, 0.1, -1>, <0.4, -0.3, 0.1>, <0.4, "
                    "0, -1>, <{}, 0.4, 0>, <0, 0.5, -1>",
                    number(-0.3, 0.3));
            case 10:
                return "polygon { 10, <-0.4, -0.4>, <0.4, -0.4>, <0.4, 0.4>, <-0.4, 0.4>, <-0.4, "
                       "-0.4>, "
                       "<-0.2, -0.1>, <0.2, -0.2>, <0.1, 0.3>, <-0.2, 0.2>, <-0.2, -0.1>";
            default:
                return fmt::format(
                    "lathe {{ {} 6, <0.05, -0.4>, <{}, -0.3>, <{}, -0.1>, <{}, 0.1>, "
                    "<{}, 0.3>, <0.05, 0.4>",
                    pick({"linear_spline", "quadratic_spline", "cubic_spline"}), number(0.1, 0.4),
                    number(0.1, 0.4), number(0.1, 0.4), number(0.1, 0.4));
        }
    }

    std::string objects() {
        std::string text = "plane { y, -0.0713 texture { pigment { " + pattern(1) + " } " +
                           finish(false) + " } }\n";
        // Each in a cell of its own: nothing touches, except opaque things in one cell.
        for (int cell = 0; cell < 6; ++cell) {
            if (chance(0.15)) continue;
            const bool glass = chance(0.35);
            const int count = glass ? 1 : 1 + below(2);
            for (int i = 0; i < count; ++i) {
                text += shape(glass);
                text += " " + (glass ? clear_or_tinted_glass() : opaque_texture());
                if (chance(0.4)) text += " rotate " + vector(-180, 180);
                text += fmt::format(" translate <{}, {}, {}>",
                                    1.1 * (cell % 3 - 1) + number(-0.03, 0.03),
                                    0.47 + 0.95 * (cell / 3), number(-0.05, 0.05));
                if (chance(0.07)) text += " no_shadow";
                if (chance(0.05)) text += " no_image";
                if (chance(0.07)) text += " no_reflection";
                if (!glass && chance(0.07)) text += " double_illuminate";
                text += " }\n";
            }
        }
        return text;
    }

    Random random_;
    bool transparent_ = true;  // whether colours may be
};

}  // namespace

std::string random_pov(std::uint64_t seed) { return Writer(seed).scene(); }

}  // namespace meniscus::test
