#include "tests/oracle/aimed_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <initializer_list>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/random_shape.hpp"
#include "tests/oracle/scene_builder.hpp"
#include "tests/random/random.hpp"

namespace meniscus::oracle {
namespace {

// Each shape stands in a place of its own; boxes, ball and cylinder touch.
const geom::Vec3 ring_at{0, 0, 2}, crystal_at{0, 1.75, 0}, cup_at{-2, 0, 0}, vase_at{2, 0, 0.5},
    pebble_at{-2, 0, 2}, cone_base{2, -1, -2}, cone_tip{2, 1, -2};

geom::Lathe cup() {
    return geom::Lathe(
        geom::Spline::linear,
        {{0.0, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {0.25, 0.5}, {0.25, 0.0}, {0.0, 0.0}});
}
geom::Lathe vase() {
    return geom::Lathe(geom::Spline::bezier, {{0.0, -0.5}, {0.75, -0.5}, {0.75, 0.5}, {0.0, 0.5}});
}

/// Round the y axis.
geom::Vec3 round(double radius, double height, double angle) {
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

/// A direction in the plane that has this normal.
geom::Vec3 along_plane(const geom::Vec3& normal, Random& random) {
    return glm::normalize(glm::cross(normal, random.direction()));
}

template <class T>
T one_of(Random& random, std::initializer_list<T> choices) {
    return choices.begin()[random.below(int(choices.size()))];
}

geom::Vec3 corner_of_boxes(Random& random) {
    return {random.below(2) - 1.0, random.below(3) - 1.0, random.below(2) - 1.0};
}

struct Line {
    geom::Vec3 point, direction;
    geom::Vec3 normal{0.0};  // of the surface that the line runs in, if it does
};

/// Somewhere along the plane through the point.
Line within(const geom::Vec3& point, const geom::Vec3& normal, Random& random) {
    return {point, along_plane(normal, random), normal};
}

Line silhouette(Random& random) {
    const double angle = random.between(-3.1, 3.1), s = random.between(-0.9, 0.9);
    geom::Vec3 point, normal;
    switch (random.below(6)) {
        case 0:  // the ball
            normal = random.direction();
            point = geom::Vec3{0.5, 0.5, -0.5} + 0.5 * normal;
            break;
        case 1:  // the cylinder
            normal = round(1.0, 0.0, angle);
            point = geom::Vec3{0.5, 0.5 * s - 0.5, -0.5} + 0.5 * normal;
            break;
        case 2:  // the cone
            normal = glm::normalize(round(1.0, 0.25, angle));
            point =
                cone_tip - (1.0 + s) * geom::Vec3{0, 1, 0} + round(0.25 * (1.0 + s), 0.0, angle);
            break;
        case 3: {  // the ring, anywhere on its tube
            const double turn = random.between(-3.1, 3.1);
            normal = round(std::cos(turn), std::sin(turn), angle);
            point = ring_at + round(1.0, 0.0, angle) + 0.25 * normal;
            break;
        }
        case 4:  // the cup's outer and inner wall
            normal = round(1.0, 0.0, angle);
            point = cup_at + (s < 0.0 ? 0.5 : 0.25) * normal + geom::Vec3{0, 0.25 + 0.2 * s, 0};
            break;
        default: {  // the vase: its curve at u and its tangent there
            const double u = random.between(0.05, 0.95), v = 1.0 - u;
            const double r = 0.75 * 3.0 * (u * v * v + u * u * v);
            const double y =
                -0.5 * (v * v * v + 3.0 * u * v * v) + 0.5 * (3.0 * u * u * v + u * u * u);
            const double dr = 0.75 * 3.0 * (v * v - u * u), dy = 6.0 * u * v * 0.5;
            normal = glm::normalize(round(dy, -dr, angle));
            point = vase_at + round(r, y, angle);
        }
    }
    return within(point, normal, random);
}

Line in_face(Random& random) {
    const double a = random.between(-0.9, -0.1), b = random.between(-0.9, -0.1);
    switch (random.below(4)) {
        case 0: {  // the faces of the boxes
            const double x = one_of(random, {-1.0, 0.0});
            return within({x, 2.0 * a + 1.0, b}, {1, 0, 0}, random);
        }
        case 1: {  // their level faces, the one that both share among them: caps of the cylinder
                   // too
            const double y = one_of(random, {-1.0, 0.0, 1.0});
            return within({a, y, b}, {0, 1, 0}, random);
        }
        case 2: {  // along an axis: exactly in the face
            const double y = one_of(random, {-1.0, 0.0, 1.0});
            return {{a, y, b},
                    random.chance(0.5) ? geom::Vec3{1, 0, 0} : geom::Vec3{0, 0, -1},
                    {0, 1, 0}};
        }
        default: {  // a face of the octahedron
            const geom::Vec3 normal{one_of(random, {-1.0, 1.0}), one_of(random, {-1.0, 1.0}),
                                    one_of(random, {-1.0, 1.0})};
            return within(crystal_at + 0.25 * normal, glm::normalize(normal), random);
        }
    }
}

Line along_edge(Random& random) {
    const double angle = random.between(-3.1, 3.1);
    switch (random.below(4)) {
        case 0: {
            geom::Vec3 direction{0.0};
            direction[random.below(3)] = 1.0;
            return {corner_of_boxes(random), direction};
        }
        case 1: {  // of the octahedron
            const geom::Vec3 a{one_of(random, {-0.75, 0.75}), 0, 0};
            const geom::Vec3 b{0, one_of(random, {-0.75, 0.75}), 0};
            return {crystal_at + 0.5 * (a + b), glm::normalize(b - a)};
        }
        case 2:  // a straight line of the cylinder's side
            return {geom::Vec3{0.5, -0.5, -0.5} + round(0.5, 0.0, angle), {0, 1, 0}};
        default:  // of the cone's
            return {cone_tip - round(0.25, 1.0, angle), glm::normalize(round(0.5, 2.0, angle))};
    }
}

Line line_at(Aim aim, Random& random) {
    const geom::Vec3 anywhere = random.direction();
    const double s = random.between(-1.0, 1.0), angle = random.between(-3.1, 3.1);
    switch (aim) {
        case Aim::corner:
            return {corner_of_boxes(random), anywhere};
        case Aim::box_edge: {
            geom::Vec3 point = corner_of_boxes(random);
            const int axis = random.below(3);
            point[axis] = axis == 1 ? s : 0.5 * s - 0.5;
            return {point, anywhere};
        }
        case Aim::mesh_vertex:
        case Aim::mesh_edge: {
            const bool of_crystal = random.chance(0.5);
            const geom::Mesh mesh = of_crystal ? octahedron(geom::Vec3{0.75}) : ball_mesh(0.5, 2);
            const auto corners =
                mesh.triangles->corners(geom::Face(random.below(int(mesh.triangles->size()))));
            const double t = aim == Aim::mesh_vertex ? 0.0 : std::abs(s);
            return {(of_crystal ? crystal_at : pebble_at) + (1.0 - t) * corners[0] + t * corners[1],
                    anywhere};
        }
        case Aim::rim:
            switch (random.below(4)) {
                case 0:
                    return {geom::Vec3{0.5, s < 0 ? -1.0 : 0.0, -0.5} + round(0.5, 0, angle),
                            anywhere};
                case 1:
                    return {cone_base + round(0.5, 0, angle), anywhere};
                case 2:
                    return {cup_at + round(s < 0 ? 0.25 : 0.5, 0.5, angle), anywhere};
                default:
                    return {cup_at + round(0.25, 0.0, angle), anywhere};
            }
        case Aim::tip:
            return {one_of(random, {cone_tip, cone_tip, cup_at, vase_at + geom::Vec3{0, 0.5, 0}}),
                    anywhere};
        case Aim::touching: {
            const geom::Vec3 point =
                one_of<geom::Vec3>(random, {{0, 0.5, -0.5}, {0.5, 0, -0.5}, {0.5, 1, -0.5}});
            // Some between the two, at a right angle to their normal.
            return {point, random.chance(0.3)
                               ? along_plane(point - geom::Vec3{0.5, 0.5, -0.5}, random)
                               : anywhere};
        }
        case Aim::silhouette:
            return silhouette(random);
        case Aim::centre: {
            const bool along = random.chance(0.5);
            return {one_of(random, {geom::Vec3{0.5, 0.5, -0.5}, geom::Vec3{0.5, -0.5, -0.5},
                                    ring_at, cup_at, vase_at, cone_tip, pebble_at, crystal_at}),
                    along ? geom::Vec3{0, s < 0 ? -1.0 : 1.0, 0} : anywhere};
        }
        case Aim::in_face:
            return in_face(random);
        case Aim::along_edge:
            return along_edge(random);
    }
    return {};
}

constexpr Picture one_ray{.width = 1, .height = 1, .limits = {.depth = 6, .cutoff = 1e-2}};

/// The same, but only what is nearer than the oracle's own rounding is in contact.
constexpr Picture one_exact_ray = [] {
    Picture picture = one_ray;
    picture.limits.contact = 1e-18;
    return picture;
}();

/// Whether the value lies between the lights of trees in which every ray starts a little beside its
/// place: near an edge rounding decides anew at every surface.
bool is_rounding(Tracer<Quad>& exact, const scene::Rgb& value) {
    Random random(1);
    exact.moved = [&](const Vector<Quad>& o) {
        return o + widen<Quad>(random.between(0.0, 1e-14) * random.direction());
    };
    scene::Rgb low{geom::infinity}, high{-geom::infinity};
    for (int i = 0; i < 300; ++i) {
        const scene::Rgb light = exact.pixel(0, 0, 1, 1);
        low = glm::min(low, light);
        high = glm::max(high, light);
    }
    return glm::all(glm::lessThan(low - 1e-6, value)) &&
           glm::all(glm::lessThan(value, high + 1e-6));
}

}  // namespace

std::string_view name(Aim aim) {
    constexpr std::array names{"corners",         "edges of boxes", "vertices of meshes",
                               "edges of meshes", "rims",           "tips",
                               "points of touch", "silhouettes",    "centres and axes",
                               "in faces",        "along edges"};
    return names[std::size_t(aim)];
}

AimedScene::AimedScene(const geom::Vec3& angles_degrees)
    : rotation_(geom::Transform::rotation_degrees(angles_degrees)) {
    const auto at = [&](const geom::Vec3& place) {
        return geom::Transform::translation(place).then(rotation_);
    };
    SceneBuilder builder;
    builder.sky({0.1, 0.1, 0.2}, {0.5, 0.7, 1.0})
        .glass(geom::Box{{-1, -1, -1}, {0, 0, 0}}, 1.5, 1, {0.1, 0.2, 0.3}, rotation_)
        .glass(geom::Box{{-1, 0, -1}, {0, 1, 0}}, 1.33, 2, {0.3, 0.1, 0.1}, rotation_)
        .glass(geom::Sphere{{0.5, 0.5, -0.5}, 0.5}, 1.5, 3, {}, rotation_)
        .glass(geom::Cylinder{{0.5, -1, -0.5}, {0.5, 0, -0.5}, 0.5, false}, 1.8, 4, {}, rotation_)
        .glass(geom::Sphere{{0.5, 1.25, -0.5}, 0.25}, 1.4, 5, {}, rotation_)
        .glass(geom::Torus{1.0, 0.25}, 1.4, 6, {0.2, 0.2, 0.0}, at(ring_at))
        .glass(octahedron(geom::Vec3{0.75}), 2.4, 7, {0.1, 0.0, 0.1}, at(crystal_at))
        .glass(ball_mesh(0.5, 2), 1.5, 8, {}, at(pebble_at))
        .glass(cup(), 1.5, 9, {}, at(cup_at))
        .glass(vase(), 1.6, 10, {0.2, 0.0, 0.0}, at(vase_at))
        .glass(geom::Cone{cone_base, 0.5, cone_tip, 0.0, false}, 1.5, 11, {}, rotation_)
        .glass(geom::Box{{-4, -3, -4}, {4, -1, 4}}, 1.33, 0.5, {0.3, 0.1, 0.1}, rotation_)
        // No ray runs along it: where parallels meet, the exact picture jumps.
        .glass(geom::Plane{{1, 7, 0.5}, -5.0}, 1.2, 0.2, {0.1, 0.1, 0.3}, rotation_);
    scene_ = builder.scene();
}

const scene::Scene& AimedScene::aimed(Aim aim, double beside, std::uint64_t seed) {
    Random random(seed);
    const Line line = line_at(aim, random);
    const geom::Vec3 aside = line.normal != geom::Vec3{0.0}
                                 ? (random.chance(0.5) ? line.normal : -line.normal)
                                 : along_plane(line.direction, random);
    scene::Camera& camera = scene_.camera;
    const double away = random.between(4.0, 6.0);
    camera.location = rotation_.point(line.point + beside * aside - away * line.direction);
    camera.direction = rotation_.vector(line.direction);
    camera.right = rotation_.vector(aside);
    camera.up = glm::cross(camera.direction, camera.right);
    return scene_;
}

AimedRay follow(const scene::Scene& scene) {
    const auto ours = rendered(scene, one_ray);
    return {ours.statistics.segments, ours.statistics.leaks};
}

AimedRay compared(const scene::Scene& scene) {
    const auto ours = rendered(scene, one_ray);
    const float* seen = ours.picture.pixel(0, 0);
    const auto difference_of = [&](const scene::Rgb& truth) {
        double difference = 0.0;
        for (int c = 0; c < 3; ++c)
            difference = std::max(difference, std::abs(double(seen[c]) - double(float(truth[c]))));
        return difference;
    };
    AimedRay ray{ours.statistics.segments, ours.statistics.leaks};
    ray.difference = difference_of(Tracer<Extended>(scene, one_ray.limits).pixel(0, 0, 1, 1));
    if (ray.difference <= 1e-9) return ray;
    const Tracer<Quad> with_contact(scene, one_ray.limits);
    Tracer<Quad> exact(scene, one_exact_ray.limits);
    ray.difference = difference_of(with_contact.pixel(0, 0, 1, 1));
    if (ray.difference <= 1e-6) return ray;
    ray.is_one_of_two = difference_of(exact.pixel(0, 0, 1, 1)) <= 1e-6;
    // The ray passes its target some five away from the film, that is within 1e-12.
    const scene::Rgb value{seen[0], seen[1], seen[2]};
    ray.is_explained = jumps_over({&with_contact, &exact}, 0, 0, one_ray, {value}, 1e-6, 2e-13) ||
                       is_rounding(exact, value);
    return ray;
}

}  // namespace meniscus::oracle
