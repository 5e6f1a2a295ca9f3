#include "povray/write_texture.hpp"

#include <cmath>

#include "geom/transform.hpp"

namespace meniscus::povray {
namespace {

using namespace scene;

/// Patterns live in the scene's own units: the texture's `scale S` comes last.
std::string own_units(const geom::Transform& transform) {
    const auto& m = transform.linear();
    const auto& t = transform.shift();
    if (transform.is_identity()) return {};
    if (transform.is_translation()) return "translate " + vector(t);
    std::string text = "matrix <";
    for (int i = 0; i < 3; ++i)
        text += fmt::format("{}, {}, {}, ", number(m[i].x), number(m[i].y), number(m[i].z));
    return text + fmt::format("{}, {}, {}>", number(t.x), number(t.y), number(t.z));
}

void write_map(Writer& writer, const ColorMap& map) {
    writer.open("color_map");
    for (const auto& entry : map.entries)
        writer.line("[{} {}]", number(entry.position), color(entry.color));
    writer.close();
}

void write_map(Writer& writer, const PigmentMap& map) {
    writer.open("pigment_map");
    for (const auto& entry : map.entries) {
        writer.line("[{}", number(entry.position));
        // an entry is the inside of a pigment block
        Writer inner;
        write_pigment(inner, *entry.pigment);
        const auto text = inner.text();
        const auto begin = text.find('{') + 1, end = text.rfind('}');
        writer.line("{}]", text.substr(begin, end - begin));
    }
    writer.close();
}

const char* wave_word(Gradient::Wave wave) {
    switch (wave) {
        case Gradient::Wave::ramp:
            return "ramp_wave";
        case Gradient::Wave::triangle:
            return "triangle_wave";
        case Gradient::Wave::sine:
            return "sine_wave";
        case Gradient::Wave::scallop:
            return "scallop_wave";
        case Gradient::Wave::cubic:
            return "cubic_wave";
        case Gradient::Wave::poly:
            break;
    }
    return "poly_wave";
}

void write_pattern(Writer& writer, const SolidColor& p) { writer.line("{}", color(p.color)); }
void write_pattern(Writer& writer, const Checker& p) {
    writer.line("checker");
    write_pigment(writer, *p.first);
    write_pigment(writer, *p.second);
}
void write_pattern(Writer& writer, const Hexagon& p) {
    writer.line("hexagon");
    for (const auto& each : {p.first, p.second, p.third}) write_pigment(writer, *each);
}
void write_pattern(Writer& writer, const Brick& p) {
    writer.line("brick");
    write_pigment(writer, *p.mortar);
    write_pigment(writer, *p.brick);
    writer.line("brick_size {}", vector(p.size));
    writer.line("mortar {}", number(p.mortar_width));
}
void write_pattern(Writer& writer, const Gradient& p) {
    writer.line("gradient {}", vector(p.direction));
    std::visit([&](const auto& map) { write_map(writer, map); }, p.map);
    if (p.frequency != 1.0) writer.line("frequency {}", number(p.frequency));
    if (p.phase != 0.0) writer.line("phase {}", number(p.phase));
    if (p.wave == Gradient::Wave::poly) {
        writer.line("poly_wave {}", number(p.exponent));
    } else if (p.wave != Gradient::Wave::ramp) {
        writer.line("{}", wave_word(p.wave));
    }
}

void write_reflection(Writer& writer, const Reflection& r) {
    if (!r.is_active()) return;
    std::string words = fmt::format("reflection {{ {}, {}", color(r.min), color(r.max));
    if (r.fresnel) words += " fresnel on";
    if (r.falloff != 1.0) words += " falloff " + number(r.falloff);
    if (r.exponent != 1.0) words += " exponent " + number(r.exponent);
    if (r.metallic != 0.0) words += " metallic " + number(r.metallic);
    writer.line("{} }}", words);
}

/// Every value, so that no default of either program enters.
void write_finish(Writer& writer, const Finish& f) {
    writer.open("finish");
    writer.line("ambient {} emission {}", color(f.ambient), color(f.emission));
    writer.line("diffuse {} brilliance {}", number(f.diffuse), number(f.brilliance));
    if (f.phong != 0.0)
        writer.line("phong {} phong_size {}", number(f.phong), number(f.phong_size));
    if (f.specular != 0.0)
        writer.line("specular {} roughness {}", number(f.specular), number(f.roughness));
    if (f.metallic != 0.0) writer.line("metallic {}", number(f.metallic));
    write_reflection(writer, f.reflection);
    if (f.conserve_energy) writer.line("conserve_energy");
    if (f.crand != 0.0) writer.line("crand {}", number(f.crand));
    writer.close();
}

}  // namespace

std::string color(const Rgb& c) { return "rgb " + vector(c); }

std::string color(const Color& c) {
    if (c.filter == 0.0 && c.transmit == 0.0) return color(c.rgb);
    return fmt::format("rgbft <{}, {}, {}, {}, {}>", number(c.rgb.r), number(c.rgb.g),
                       number(c.rgb.b), number(c.filter), number(c.transmit));
}

void write_pigment(Writer& writer, const Pigment& pigment) {
    const auto moved = own_units(pigment.transform);
    if (const auto* solid = std::get_if<SolidColor>(&pigment.pattern)) {
        writer.line("pigment {{ {} }}", color(solid->color));
        return;
    }
    writer.open("pigment");
    std::visit([&](const auto& pattern) { write_pattern(writer, pattern); }, pigment.pattern);
    if (!moved.empty()) writer.line("{}", moved);
    writer.close();
}

void write_texture(Writer& writer, const Texture& texture) {
    writer.open("texture");
    if (texture.clear) {
        writer.line("pigment {{ rgbt 1 }}");
        writer.line(
            "finish {{ ambient 0 diffuse 0 reflection {{ 0, 1 fresnel on }} conserve_energy }}");
    } else {
        write_pigment(writer, texture.pigment);
        write_finish(writer, texture.finish);
        if (!std::holds_alternative<SolidColor>(texture.pigment.pattern)) {
            if (const auto moved = own_units(texture.transform); !moved.empty())
                writer.line("{}", moved);
            writer.line("scale S");
        }
    }
    writer.close();
}

}  // namespace meniscus::povray
