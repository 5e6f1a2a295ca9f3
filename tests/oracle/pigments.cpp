#include "tests/oracle/pigments.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace meniscus::oracle {
namespace {

geom::Vec3 into(const geom::Transform& transform, const geom::Vec3& p) {
    return transform.inverse_linear() * (p - transform.shift());
}

scene::Color mix(const scene::Color& a, const scene::Color& b, double s) {
    return {(1.0 - s) * a.rgb + s * b.rgb, (1.0 - s) * a.filter + s * b.filter,
            (1.0 - s) * a.transmit + s * b.transmit};
}

scene::Color look_up(const scene::ColorMap& map, double v) {
    if (v <= map.entries.front().position) return map.entries.front().color;
    for (std::size_t i = 1; i < map.entries.size(); ++i) {
        const auto &a = map.entries[i - 1], &b = map.entries[i];
        if (v > b.position) continue;
        return mix(a.color, b.color, (v - a.position) / (b.position - a.position));
    }
    return map.entries.back().color;
}

scene::Color color_of(const scene::SolidColor& solid, const geom::Vec3&) { return solid.color; }

scene::Color color_of(const scene::Checker& checker, const geom::Vec3& p) {
    const double cells =
        std::floor(p.x + 1e-10) + std::floor(p.y + 1e-10) + std::floor(p.z + 1e-10);
    const bool even = std::fmod(cells, 2.0) == 0.0;
    return color_at(even ? *checker.first : *checker.second, p);
}

scene::Color color_of(const scene::Gradient& gradient, const geom::Vec3& p) {
    const auto* map = std::get_if<scene::ColorMap>(&gradient.map);
    if (!map || gradient.wave != scene::Gradient::Wave::ramp)
        throw std::invalid_argument("the oracle knows ramps of colours only");
    double v = glm::dot(p, glm::normalize(gradient.direction));
    if (v > 1.0) v = std::fmod(v, 1.0);
    v = std::fmod(v * gradient.frequency + gradient.phase, 1.00001);
    if (v < 0.0) v -= std::floor(v);
    return look_up(*map, v);
}

template <class Pattern>
scene::Color color_of(const Pattern&, const geom::Vec3&) {
    throw std::invalid_argument("the oracle does not know this pattern");
}

}  // namespace

scene::Color color_at(const scene::Pigment& pigment, const geom::Vec3& p) {
    const geom::Vec3 q = into(pigment.transform, p);
    return std::visit([&](const auto& pattern) { return color_of(pattern, q); }, pigment.pattern);
}

scene::Rgb sky(const scene::Scene& scene, const geom::Vec3& direction) {
    scene::Rgb light = (1.0 - scene.background.transmit) * scene.background.rgb;
    for (const scene::Pigment& pigment : scene.sky_sphere.pigments) {
        const scene::Color c = color_at(pigment, direction);
        light = scene.sky_sphere.emission * c.opacity() * c.rgb + c.transparency() * light;
    }
    return light;
}

}  // namespace meniscus::oracle
