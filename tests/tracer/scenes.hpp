#pragma once

#include <memory>

#include "scene/scene.hpp"

/// Small scenes for the tracer's tests, as plain values.
namespace meniscus::test {

using geom::Vec3;

inline scene::Pigment plain(const scene::Rgb& rgb, double filter = 0.0, double transmit = 0.0) {
    return {.pattern = scene::SolidColor{{rgb, filter, transmit}}, .transform = {}};
}

inline std::size_t add_texture(scene::Scene& scene, const scene::Texture& texture) {
    scene.textures.push_back(texture);
    return scene.textures.size() - 1;
}

inline scene::Texture emissive(const scene::Pigment& pigment) {
    scene::Texture texture;
    texture.pigment = pigment;
    texture.finish.ambient = scene::Rgb{0.0};
    texture.finish.emission = scene::Rgb{1.0};
    texture.finish.diffuse = 0.0;
    return texture;
}

inline scene::Texture matte(const scene::Pigment& pigment) {
    scene::Texture texture;
    texture.pigment = pigment;
    texture.finish.ambient = scene::Rgb{0.0};
    texture.finish.diffuse = 1.0;
    return texture;
}

/// A clear dielectric of its own.
inline scene::Object& add_glass(scene::Scene& scene, geom::Shape shape, double ior, double priority,
                                const scene::Rgb& absorption = scene::Rgb{0.0}) {
    scene::Interior interior;
    interior.ior = ior;
    interior.priority = priority;
    interior.absorption = absorption;
    interior.states_ior = interior.states_priority = true;
    scene.solids.push_back({"glass", {}, interior});
    scene::Object object;
    object.shape = std::move(shape);
    object.solid = scene.solids.size() - 1;
    object.texture = add_texture(scene, scene::Texture::clear_skin());
    object.name = "glass";
    scene.objects.push_back(std::move(object));
    return scene.objects.back();
}

inline scene::Object& add_opaque(scene::Scene& scene, geom::Shape shape,
                                 const scene::Texture& texture) {
    scene.solids.push_back({"opaque", {}, {}});
    scene::Object object;
    object.shape = std::move(shape);
    object.solid = scene.solids.size() - 1;
    object.texture = add_texture(scene, texture);
    object.name = "opaque";
    scene.objects.push_back(std::move(object));
    return scene.objects.back();
}

inline scene::Pigment checker(const scene::Rgb& a, const scene::Rgb& b) {
    return {.pattern = scene::Checker{std::make_shared<scene::Pigment>(plain(a)),
                                      std::make_shared<scene::Pigment>(plain(b))},
            .transform = {}};
}

/// Looks from `from` to the origin, 40 degrees wide.
inline void look(scene::Scene& scene, const Vec3& from) {
    scene.camera.location = from;
    const Vec3 d = glm::normalize(-from);
    const Vec3 right = glm::normalize(glm::cross(Vec3{0.0, 1.0, 0.0}, d));
    scene.camera.direction =
        d * (0.5 * (4.0 / 3.0) / std::tan(20.0 * 3.14159265358979323846 / 180.0));
    scene.camera.right = right * (4.0 / 3.0);
    scene.camera.up = glm::cross(d, right);
}

}  // namespace meniscus::test
