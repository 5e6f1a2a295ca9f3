#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <string>

#include "scene/scene.hpp"

namespace meniscus::oracle {

inline scene::Pigment plain(const scene::Color& color) { return {scene::SolidColor{color}, {}}; }

inline scene::Pigment checker(const scene::Rgb& first, const scene::Rgb& second) {
    return {scene::Checker{std::make_shared<scene::Pigment>(plain({first})),
                           std::make_shared<scene::Pigment>(plain({second}))},
            {}};
}

/// Puts a scene together from plain values.
class SceneBuilder {
public:
    /// A camera with square pixels.
    SceneBuilder& camera(const geom::Vec3& location, const geom::Vec3& look_at,
                         double angle_degrees, double aspect = 4.0 / 3.0) {
        const geom::Vec3 ahead = glm::normalize(look_at - location);
        const geom::Vec3 right = glm::normalize(glm::cross(geom::Vec3{0.0, 1.0, 0.0}, ahead));
        scene_.camera.location = location;
        scene_.camera.direction =
            aspect / (2.0 * std::tan(angle_degrees * std::acos(-1.0) / 360.0)) * ahead;
        scene_.camera.right = aspect * right;
        scene_.camera.up = glm::cross(ahead, right);
        return *this;
    }

    /// From `low` straight down to `high` straight up.
    SceneBuilder& sky(const scene::Rgb& low, const scene::Rgb& high) {
        scene::Gradient gradient;
        gradient.direction = {0.0, 1.0, 0.0};
        gradient.map = scene::ColorMap{{{0.0, {low}}, {1.0, {high}}}};
        const auto into_unit = geom::Transform::scaling(geom::Vec3{2.0})
                                   .then(geom::Transform::translation({0.0, -1.0, 0.0}));
        scene_.sky_sphere.pigments = {{gradient, into_unit}};
        return *this;
    }

    SceneBuilder& lamp(const geom::Vec3& position, const scene::Rgb& color) {
        scene::Light light;
        light.position = position;
        light.color = color;
        scene_.lights.push_back(light);
        return *this;
    }

    SceneBuilder& outside(const scene::Interior& interior) {
        scene_.settings.outside = interior;
        return *this;
    }

    /// A solid of one object under the clear skin.
    SceneBuilder& glass(const geom::Shape& shape, double ior, double priority,
                        const scene::Rgb& absorption = scene::Rgb{0.0},
                        const geom::Transform& transform = {}) {
        return solid(shape, medium(ior, priority, absorption), scene::Texture::clear_skin(),
                     transform);
    }

    /// An opaque solid that stands in no list. Its texture goes with it.
    SceneBuilder& opaque(const geom::Shape& shape, const scene::Pigment& pigment,
                         const scene::Finish& finish = {}, const geom::Transform& transform = {}) {
        scene::Texture texture;
        texture.pigment = pigment;
        texture.finish = finish;
        texture.transform = transform;
        return solid(shape, {}, texture, transform);
    }

    SceneBuilder& solid(const geom::Shape& shape, const scene::Interior& interior,
                        const scene::Texture& texture, const geom::Transform& transform = {}) {
        scene::Object object;
        object.shape = shape;
        object.transform = transform;
        object.solid = scene_.solids.size();
        object.texture = scene_.textures.size();
        object.name = std::string(geom::keyword(shape)) + " " + std::to_string(object.solid);
        scene_.solids.push_back({object.name, {}, interior});
        scene_.textures.push_back(texture);
        scene_.objects.push_back(object);
        return *this;
    }

    /// Adds a further object to the solid made last: its surface wears the same skin.
    SceneBuilder& united_with(const geom::Shape& shape, const geom::Transform& transform = {}) {
        scene::Object object = scene_.objects.back();
        object.shape = shape;
        object.transform = transform;
        scene_.objects.push_back(object);
        return *this;
    }

    SceneBuilder& inverse() {
        scene_.objects.back().inverse = true;
        return *this;
    }

    static scene::Interior medium(double ior, double priority,
                                  const scene::Rgb& absorption = scene::Rgb{0.0}) {
        scene::Interior interior;
        interior.ior = ior;
        interior.priority = priority;
        interior.absorption = absorption;
        interior.states_ior = interior.states_priority = true;
        return interior;
    }

    const scene::Scene& scene() const { return scene_; }
    scene::Scene& scene() { return scene_; }

private:
    scene::Scene scene_;
};

}  // namespace meniscus::oracle
