#include "tracer/brightness.hpp"

#include <algorithm>
#include <cmath>

namespace meniscus::tracer {
namespace {

double greatest(const scene::Rgb& c) {
    return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)});
}

double greatest(const scene::Pigment& pigment);

double greatest(const scene::SolidColor& solid) { return greatest(solid.color.rgb); }
double greatest(const scene::Checker& checker) {
    return std::max(greatest(*checker.first), greatest(*checker.second));
}
double greatest(const scene::Hexagon& hexagon) {
    return std::max(
        {greatest(*hexagon.first), greatest(*hexagon.second), greatest(*hexagon.third)});
}
double greatest(const scene::Brick& brick) {
    return std::max(greatest(*brick.mortar), greatest(*brick.brick));
}
double greatest(const scene::Gradient& gradient) {
    double result = 0.0;
    if (const auto* colors = std::get_if<scene::ColorMap>(&gradient.map)) {
        for (const auto& entry : colors->entries)
            result = std::max(result, greatest(entry.color.rgb));
    } else {
        for (const auto& entry : std::get<scene::PigmentMap>(gradient.map).entries)
            result = std::max(result, greatest(*entry.pigment));
    }
    return result;
}

double greatest(const scene::Pigment& pigment) {
    return std::visit([](const auto& pattern) { return greatest(pattern); }, pigment.pattern);
}

}  // namespace

double brightest(const scene::Scene& scene) {
    double lights = 0.0;
    for (const scene::Light& light : scene.lights) lights += 2.0 * greatest(light.color);  // fading
    double surface = 0.0;
    for (const scene::Texture& texture : scene.textures) {
        if (texture.clear) continue;
        const scene::Finish& finish = texture.finish;
        const double color = greatest(texture.pigment);
        const double own =
            greatest(finish.ambient * scene.settings.ambient_light) + greatest(finish.emission);
        const double highlights = std::abs(finish.phong) + std::abs(finish.specular);
        const double tint = std::max(1.0, 1.0 + std::abs(finish.metallic) * (1.0 + color));
        surface = std::max(
            surface,
            color * own + lights * ((std::abs(finish.diffuse) + std::abs(finish.crand)) * color +
                                    highlights * tint));
    }
    double sky = greatest(scene.background.rgb);
    for (const scene::Pigment& pigment : scene.sky_sphere.pigments)
        sky += std::abs(scene.sky_sphere.emission) * greatest(pigment);
    return std::max(surface, sky);
}

}  // namespace meniscus::tracer
