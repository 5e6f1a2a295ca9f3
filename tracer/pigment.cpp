#include "tracer/pigment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/crossing.hpp"

namespace meniscus::tracer {

namespace {

using geom::Vec3;
using scene::Color;

double fraction(double x) { return x - std::floor(x); }

Color mix(const Color& a, const Color& b, double t) {
    return {a.rgb + t * (b.rgb - a.rgb), a.filter + t * (b.filter - a.filter),
            a.transmit + t * (b.transmit - a.transmit)};
}

/// Looks up a value in a map: ends are clamped, and of two entries at one position the first holds
/// there.
template <class Map, class ColorOf>
Color look_up(const Map& map, double value, ColorOf&& color_of) {
    const auto& entries = map.entries;
    if (entries.empty()) return {};
    const auto next =
        std::ranges::find_if(entries, [&](const auto& entry) { return value <= entry.position; });
    if (next == entries.begin()) return color_of(entries.front());
    if (next == entries.end()) return color_of(entries.back());
    const auto previous = next - 1;
    const double width = next->position - previous->position;
    if (!(width > 0.0) || value == next->position) return color_of(*next);
    return mix(color_of(*previous), color_of(*next), (value - previous->position) / width);
}

Color evaluate(const scene::SolidColor& pattern, const Vec3&) { return pattern.color; }

/// Parity of the unit cell; the small shift keeps surfaces in the planes between cells from
/// speckling, as POV-Ray's does.
Color evaluate(const scene::Checker& pattern, const Vec3& p) {
    const double cell = std::floor(p.x + 1e-10) + std::floor(p.y + 1e-10) + std::floor(p.z + 1e-10);
    const bool odd = std::fmod(std::abs(cell), 2.0) == 1.0;
    return tracer::evaluate(odd ? *pattern.second : *pattern.first, p);
}

/// Regular hexagons of circumradius 1 in the x-z plane, with centres (1.5 i, sqrt(3) (j + i / 2))
/// and colour (2 i + j) mod 3.
Color evaluate(const scene::Hexagon& pattern, const Vec3& p) {
    const double height = std::numbers::sqrt3;
    const int i0 = int(std::floor(p.x / 1.5));
    double nearest = geom::infinity;
    long long color = 0;
    for (int i = i0; i <= i0 + 1; ++i) {
        const double j = std::round(p.z / height - 0.5 * i);
        const double dx = p.x - 1.5 * i, dz = p.z - height * (j + 0.5 * i);
        const double distance = dx * dx + dz * dz;
        if (distance < nearest) {
            nearest = distance;
            color = 2LL * i + (long long)(j);
        }
    }
    color = ((color % 3) + 3) % 3;
    return tracer::evaluate(color == 0   ? *pattern.first
                            : color == 1 ? *pattern.second
                                         : *pattern.third,
                            p);
}

/// Courses of bricks, each row shifted by half along x or z in turn (POV-Ray's rule, measured).
Color evaluate(const scene::Brick& pattern, const Vec3& p) {
    const Vec3 q = p + Vec3{pattern.mortar_width + 1e-10};
    const Vec3 mortar = pattern.mortar_width / pattern.size;
    const bool shifted = fraction(q.y / pattern.size.y / 2.0) > 0.5;
    const bool is_mortar = fraction(q.y / pattern.size.y) <= mortar.y ||
                           fraction(q.x / pattern.size.x + (shifted ? 0.5 : 0.0)) <= mortar.x ||
                           fraction(q.z / pattern.size.z + (shifted ? 0.0 : 0.5)) <= mortar.z;
    return tracer::evaluate(is_mortar ? *pattern.mortar : *pattern.brick, p);
}

double wave(const scene::Gradient& pattern, double v) {
    using enum scene::Gradient::Wave;
    switch (pattern.wave) {
        case ramp:
            return v;
        case triangle:
            return fraction(v) < 0.5 ? 2.0 * fraction(v) : 2.0 * (1.0 - fraction(v));
        case sine:
            return 0.5 * (1.0 + std::sin(2.0 * std::numbers::pi * v));
        case scallop:
            return std::abs(std::sin(std::numbers::pi * v));
        case cubic:
            return v * v * (3.0 - 2.0 * v);
        case poly:
            return std::pow(v, pattern.exponent);
    }
    return v;
}

/// The signed position along the direction, wrapped as POV-Ray wraps it (1.00001 is its constant),
/// then shaped by the wave.
Color evaluate(const scene::Gradient& pattern, const Vec3& p) {
    double v = glm::dot(p, glm::normalize(pattern.direction));
    if (v > 1.0) v = std::fmod(v, 1.0);
    if (pattern.frequency != 0.0) v = std::fmod(v * pattern.frequency + pattern.phase, 1.00001);
    if (v < 0.0) v -= std::floor(v);
    v = wave(pattern, v);
    if (const auto* colors = std::get_if<scene::ColorMap>(&pattern.map)) {
        return look_up(*colors, v, [](const auto& entry) { return entry.color; });
    }
    return look_up(std::get<scene::PigmentMap>(pattern.map), v,
                   [&](const auto& entry) { return tracer::evaluate(*entry.pigment, p); });
}

}  // namespace

scene::Color evaluate(const scene::Pigment& pigment, const geom::Vec3& point) {
    const Vec3 p = pigment.transform.to_local(point);
    return std::visit([&](const auto& pattern) { return evaluate(pattern, p); }, pigment.pattern);
}

scene::Color evaluate(const scene::Texture& texture, const geom::Vec3& point) {
    if (texture.clear) return {.rgb = scene::Rgb{1.0}, .filter = 0.0, .transmit = 1.0};
    return evaluate(texture.pigment, texture.transform.to_local(point));
}

}  // namespace meniscus::tracer
