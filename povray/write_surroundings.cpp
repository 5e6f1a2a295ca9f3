#include "povray/write_surroundings.hpp"

#include <algorithm>

#include "povray/precision.hpp"
#include "povray/write_texture.hpp"

namespace meniscus::povray {
namespace {

using namespace scene;

void write_settings(Writer& writer, const Settings& settings) {
    writer.open("global_settings");
    const WorkingSpace& space = settings.working_space;
    writer.line("assumed_gamma {}", space.is_srgb ? "srgb" : number(space.gamma));
    writer.line("max_trace_level {}",
                std::min(settings.max_trace_level.value_or(5), most_trace_levels));
    writer.line("adc_bailout {}", number(settings.adc_bailout.value_or(1.0 / 255.0)));
    if (settings.ambient_light != Rgb{1.0})
        writer.line("ambient_light {}", color(settings.ambient_light));
    writer.close();
}

void write_camera(Writer& writer, const Camera& camera) {
    const bool is_flat = camera.kind == Camera::Kind::orthographic;
    writer.open("camera");
    writer.line("{}", is_flat ? "orthographic" : "perspective");
    writer.line("location {}", place(camera.location));
    writer.line("direction {}", vector(camera.direction));
    writer.line("right {}", is_flat ? place(camera.right) : vector(camera.right));
    writer.line("up {}", is_flat ? place(camera.up) : vector(camera.up));
    writer.close();
}

void write_light(Writer& writer, const Light& light) {
    writer.open("light_source");
    writer.line("{}, {}", place(light.position), color(light.color));
    if (light.kind == Light::Kind::spot) {
        writer.line("spotlight radius {} falloff {} tightness {}", number(light.radius),
                    number(light.falloff), number(light.tightness));
    } else if (light.kind == Light::Kind::cylinder) {
        writer.line("cylinder radius {} falloff {} tightness {}", length(light.radius),
                    length(light.falloff), number(light.tightness));
    }
    if (light.parallel) writer.line("parallel");
    if (light.parallel || light.kind != Light::Kind::point)
        writer.line("point_at {}", place(light.point_at));
    if (light.shadowless) writer.line("shadowless");
    if (light.fade_distance != 0.0 && light.fade_power != 0.0)
        writer.line("fade_distance {} fade_power {}", length(light.fade_distance),
                    number(light.fade_power));
    writer.close();
}

}  // namespace

void write_surroundings(Writer& writer, const Scene& scene) {
    write_settings(writer, scene.settings);
    writer.blank();
    write_camera(writer, scene.camera);
    if (scene.background != Color{}) {
        writer.blank();
        writer.line("background {{ {} }}", color(scene.background));
    }
    if (!scene.sky_sphere.pigments.empty()) {
        writer.blank();
        writer.open("sky_sphere");
        for (const auto& pigment : scene.sky_sphere.pigments) write_pigment(writer, pigment);
        if (scene.sky_sphere.emission != 1.0)
            writer.line("emission {}", color(Rgb{scene.sky_sphere.emission}));
        writer.close();
    }
    for (const auto& light : scene.lights) {
        writer.blank();
        write_light(writer, light);
    }
}

}  // namespace meniscus::povray
