#pragma once

#include <cmath>

#include "inspect/check.hpp"
#include "inspect/names.hpp"
#include "inspect/pixel_trace.hpp"
#include "scene/scene.hpp"

/// Small scenes as plain values.
namespace meniscus::test {

using geom::Vec3;

/// A clear dielectric with a name, declared on the next line of "test.scene".
inline scene::Object& add_medium(scene::Scene& scene, const std::string& name, geom::Shape shape,
                                 double ior, double priority) {
    const scene::Location location{"test.scene", int(scene.objects.size()) + 1, 1};
    scene::Interior interior;
    interior.ior = ior;
    interior.priority = priority;
    interior.states_ior = interior.states_priority = true;
    scene.solids.push_back({name, location, interior});
    scene.textures.push_back(scene::Texture::clear_skin());
    scene::Object object;
    object.shape = std::move(shape);
    object.solid = scene.solids.size() - 1;
    object.texture = scene.textures.size() - 1;
    object.name = name;
    object.location = location;
    scene.objects.push_back(std::move(object));
    return scene.objects.back();
}

/// A grey, opaque object without an interior.
inline scene::Object& add_opaque(scene::Scene& scene, const std::string& name, geom::Shape shape) {
    auto& object = add_medium(scene, name, std::move(shape), 1.0, 0.0);
    scene.solids.back().interior = {};
    scene.textures.back() = {};
    scene.textures.back().pigment = {.pattern = scene::SolidColor{{scene::Rgb{0.5}, 0.0, 0.0}},
                                     .transform = {}};
    return object;
}

/// Two overlapping boxes on the z axis: Glass from 0 to 2 over Water from 1 to 4; a white sky.
inline scene::Scene glass_over_water() {
    scene::Scene scene;
    scene.background.rgb = scene::Rgb{1.0};
    scene.camera.location = {0.0, 0.0, -5.0};
    add_medium(scene, "Glass", geom::Box{{-9.0, -9.0, 0.0}, {9.0, 9.0, 2.0}}, 1.5, 2.0);
    add_medium(scene, "Water", geom::Box{{-9.0, -9.0, 1.0}, {9.0, 9.0, 4.0}}, 1.33, 1.0);
    return scene;
}

inline geom::Ray ray(const Vec3& origin, const Vec3& direction) {
    geom::Ray ray;
    ray.origin = origin;
    ray.direction = glm::normalize(direction);
    return ray;
}

/// A scene made ready, with all that a trace refers to.
struct Traced {
    tracer::RenderScene scene;
    inspect::Names names;
    inspect::PixelTrace trace;

    Traced(const scene::Scene& source, const geom::Ray& ray, tracer::Options options = whitted())
        : scene(tracer::compile(source)),
          names(scene.source),
          trace(inspect::trace_ray(scene, names, options, ray)) {}

    static tracer::Options whitted() {
        tracer::Options options;
        options.tree = tracer::Tree::whitted;
        return options;
    }
    std::string list(const inspect::Listing& listing) const {
        return inspect::text(names, listing);
    }
    /// The segments that were refracted at each surface in turn, from the camera on.
    std::vector<const inspect::Segment*> refracted_path() const {
        std::vector<const inspect::Segment*> path;
        int last = -1;
        for (std::size_t i = 0; i < trace.segments.size(); ++i) {
            const auto& node = trace.segments[i].node;
            if (node.parent != last || node.branch == tracer::TreeNode::Branch::reflected) continue;
            path.push_back(&trace.segments[i]);
            last = int(i);
        }
        return path;
    }
};

}  // namespace meniscus::test
