#include "povray/film.hpp"

#include <algorithm>
#include <cmath>

#include "geom/placed_shape.hpp"
#include "inspect/sample_lines.hpp"
#include "povray/directions.hpp"
#include "povray/grow.hpp"

namespace meniscus::povray {
namespace {

using geom::Vec3;

/// Where the ray first meets the surface; infinity if it does not.
double first_hit(const geom::PlacedShape& shape, const geom::Ray& ray) {
    geom::Crossings ends;
    shape.crossings(ray, ends);
    double nearest = geom::infinity;
    for (const auto& end : ends) {
        if (end.t > 0.0) nearest = std::min(nearest, end.t);
    }
    return nearest;
}

/// How far the surface is from a point, known to be no farther than `bound` in direction `way`: by
/// a search over directions, which also finds edges.
double distance(const geom::PlacedShape& shape, const Vec3& point, Vec3 way, double bound) {
    constexpr int directions = 96;
    const auto look = [&](const Vec3& direction) {
        geom::Ray ray;
        ray.origin = point;
        ray.direction = glm::normalize(direction);
        const double t = first_hit(shape, ray);
        if (!(t < bound)) return false;
        bound = t;
        way = ray.direction;
        return true;
    };
    for (int i = 0; i < directions; ++i) look(spread_direction(i, directions));
    // The lattice's are some 0.2 apart. An edge is a sharp valley among directions, which only a
    // try along it descends: each step looks round in turns that never repeat.
    constexpr int tries = 32;
    double turn = 0.0;
    for (double step = 0.2; step > 1e-4; step *= 0.7) {
        for (int i = 0; i < tries; ++i) {
            turn += golden_angle;
            const Vec3 side = glm::normalize(
                glm::cross(way, std::abs(way.x) < 0.5 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0}));
            const Vec3 up = glm::cross(way, side);
            look(way + step * (std::cos(turn) * side + std::sin(turn) * up));
        }
    }
    return bound;
}

/// From points of the part's surface to the grown one: along its normal, but where that runs up
/// within a wall, as beside a corner within a glass, to the nearest.
void measure(const tracer::RenderScene& scene, int index, const scene::Object& grown_object,
             std::optional<Thickness>& thickness) {
    const auto& part = scene.parts[std::size_t(index)];
    const geom::PlacedShape outer(grown_object.shape, grown_object.transform);
    const double sign = part.inverse ? -1.0 : 1.0;
    const auto box = inspect::common_region(scene, part, part, 0.0);
    for (const auto& line : inspect::sample_lines(box, 100)) {
        geom::Crossings crossings;
        part.shape.crossings(line, crossings);
        for (const auto& crossing : crossings) {
            geom::Ray ray;
            ray.origin = part.shape.on_face(crossing.face, line.at(crossing.t));
            ray.direction = sign * part.shape.normal(crossing.face, ray.origin);
            double nearest = first_hit(outer, ray);
            if (!std::isfinite(nearest)) continue;
            if (!thickness || nearest > thickness->largest)
                nearest = distance(outer, ray.origin, ray.direction, nearest);
            if (!thickness) thickness = Thickness{nearest, nearest};
            thickness->least = std::min(thickness->least, nearest);
            thickness->largest = std::max(thickness->largest, nearest);
        }
    }
}

}  // namespace

scene::Object film_part(const tracer::RenderScene& scene, const Body& body, int part, double gap) {
    const auto& object = scene.source.objects[std::size_t(scene.parts[std::size_t(part)].object)];
    return body.is_outside ? object : grown(object, gap);
}

Filmed with_films(scene::Scene source, double gap) {
    const auto compiled = tracer::compile(std::move(source));
    const Plan plan = make_plan(compiled);
    Filmed result{compiled.source, std::nullopt};
    scene::Scene& scene = result.scene;
    const std::size_t clear = scene.textures.size();
    scene.textures.push_back(scene::Texture::clear_skin());

    // What is hidden in a higher solid has no place in the plan, and stays below all.
    for (const auto& part : compiled.parts) {
        if (part.is_member) scene.solids[std::size_t(part.solid)].interior.priority = 0.0;
    }
    int lowest = 0;
    for (const Body& body : plan.bodies) lowest = std::max(lowest, body.rank);
    const auto add_film = [&](const std::string& name, const scene::Location& location,
                              double priority, const std::vector<scene::Object>& parts) {
        scene::Solid film{name + "'s film", location, scene.settings.outside};
        film.interior.priority = priority;
        film.interior.states_ior = film.interior.states_priority = true;
        scene.solids.push_back(film);
        for (auto part : parts) {
            part.solid = scene.solids.size() - 1;
            part.texture = clear;
            part.no_shadow = part.no_image = part.no_reflection = false;
            scene.objects.push_back(std::move(part));
        }
    };
    for (const Body& body : plan.bodies) {
        // ranks 0, 1, 2 become priorities from above, with room for a film below each
        const double priority = 2.0 * (lowest - body.rank) + 2.0;
        auto& solid = scene.solids[std::size_t(body.solid)];
        solid.interior.priority = priority;
        solid.interior.states_priority = true;
        if (body.lower.empty() || body.is_outside) continue;
        std::vector<scene::Object> parts;
        for (const int part : body.parts) {
            parts.push_back(film_part(compiled, body, part, gap));
            measure(compiled, part, parts.back(), result.thickness);
        }
        add_film(solid.name, solid.location, priority - 1.0, parts);
    }
    for (const int part : plan.filmed) {
        const auto& object =
            compiled.source.objects[std::size_t(compiled.parts[std::size_t(part)].object)];
        const auto film = grown(object, gap);
        measure(compiled, part, film, result.thickness);
        add_film(object.name, object.location, 2.0 * lowest + 3.0, {film});
    }
    return result;
}

}  // namespace meniscus::povray
