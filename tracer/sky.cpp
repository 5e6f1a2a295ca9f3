#include "tracer/sky.hpp"

#include "tracer/pigment.hpp"

namespace meniscus::tracer {

scene::Rgb sky(const scene::Scene& scene, const geom::Vec3& direction,
               const scene::Interior& around) {
    scene::Rgb light = scene.background.rgb;
    for (const scene::Pigment& pigment : scene.sky_sphere.pigments) {
        const scene::Color color = evaluate(pigment, direction);
        light =
            scene.sky_sphere.emission * color.opacity() * color.rgb + color.transparency() * light;
    }
    for (int i = 0; i < 3; ++i) {
        if (around.absorption[i] > 0.0) light[i] = 0.0;
        if (!around.fade.is_active()) continue;
        const double left = around.fade.color[i];
        if (around.fade.power >= 1000.0) {
            if (left < 1.0) light[i] = 0.0;
        } else {
            light[i] *= around.fade.power == 0.0 ? 0.5 * (1.0 + left) : left;
        }
    }
    return light;
}

}  // namespace meniscus::tracer
