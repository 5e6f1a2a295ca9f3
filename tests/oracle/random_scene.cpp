#include "tests/oracle/random_scene.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/oracle/random_shape.hpp"
#include "tests/oracle/scene_builder.hpp"

namespace meniscus::oracle {
namespace {

scene::Texture random_skin(Random& random) {
    scene::Texture texture;
    scene::Color color{random.point(0.3, 1.0)};
    color.filter = random.chance(0.5) ? random.between(0.2, 0.9) : 0.0;
    color.transmit = random.between(0.0, 1.0 - color.filter);
    if (color.filter + color.transmit == 0.0) color.transmit = 0.5;
    texture.pigment = plain(color);
    texture.finish.ambient = scene::Rgb{random.between(0.0, 0.3)};
    texture.finish.diffuse = random.between(0.0, 0.7);
    if (random.chance(0.3)) texture.finish.phong = random.between(0.1, 0.6);
    if (random.chance(0.3)) texture.finish.specular = random.between(0.1, 0.6);
    if (random.chance(0.7)) {
        texture.finish.reflection.max = scene::Rgb{1.0};
        texture.finish.reflection.fresnel = true;
        texture.finish.conserve_energy = true;
    }
    return texture;
}

/// A half-space holds everything: its complement or an unlucky one would fill the view, so few are
/// drawn.
geom::Shape random_half_space(Random& random) {
    return geom::Plane{Random::along(random.below(3), random.chance(0.5) ? 1.0 : -1.0),
                       random.lattice(-1.5, 0.5)};
}

}  // namespace

RandomSceneOptions every_kind(std::uint64_t seed) {
    RandomSceneOptions options;
    options.fewest_solids = 2;
    options.most_solids = 12;
    options.rotated = seed % 2 == 1;
    options.stretched = seed % 3 == 1;
    options.sheared = seed % 5 == 1;
    options.scattered = seed % 4 == 2;
    options.cones = options.tori = options.lathes = options.meshes = true;
    options.unions = seed % 3 == 2;
    options.complements = seed % 7 == 1;
    options.textured = seed % 4 == 3;
    options.opaque_members = seed % 5 == 3;
    if (seed % 11 == 3) options.scale = 1e-6;
    if (seed % 11 == 7) options.scale = 1e6;
    // Not small and far away at once: the oracle, which knows no frames, takes what is nearer than
    // the rounding of the place for contact, and at 1000 that is a 200,000th of a solid of 1e-6.
    if (options.scale >= 1.0) {
        if (seed % 13 == 5) options.offset = {1000.3, 777.7, -1234.1};
        if (seed % 13 == 9) options.offset = {1000000.3, 700007.7, -1234567.1};
    }
    return options;
}

scene::Scene random_scene(std::uint64_t seed, const RandomSceneOptions& options) {
    Random random(seed);
    SceneBuilder builder;

    // Few media, so that like ones meet.
    struct Medium {
        double ior;
        scene::Rgb absorption;
    };
    std::vector<Medium> media{{1.0, scene::Rgb{0.0}}};
    for (const double ior : {1.31, 1.33, 1.5, 1.5, 1.8, 2.4}) {
        media.push_back({ior, random.chance(0.5) ? random.point(0.0, 0.6) : scene::Rgb{0.0}});
    }

    const geom::Vec3 angles = options.rotated ? random.point(-180.0, 180.0) : geom::Vec3{0.0};
    const auto rotation = geom::Transform::rotation_degrees(angles);
    const geom::Vec3 skew = options.sheared ? random.point(-0.6, 0.6) : geom::Vec3{0.0};
    const geom::Transform shear(
        geom::Mat3{{1.0, 0.0, 0.0}, {skew.x, 1.0, 0.0}, {skew.y, skew.z, 1.0}}, geom::Vec3{0.0});
    const auto whole = shear.then(geom::Transform::scaling(geom::Vec3{options.scale}))
                           .then(geom::Transform::translation(options.offset));
    // The shape, whose coordinates are relative to `origin` and divided by `stretch`, into the
    // scene.
    const auto place = [&](const geom::Vec3& origin, const geom::Vec3& stretch) {
        auto transform = geom::Transform{};
        if (stretch != geom::Vec3{1.0}) transform = geom::Transform::scaling(stretch);
        if (origin != geom::Vec3{0.0})
            transform = transform.then(geom::Transform::translation(origin));
        if (options.scattered)
            transform = transform.then(geom::Transform::translation(random.point(-0.2, 0.2)));
        return transform.then(rotation).then(whole);
    };

    const int count =
        options.fewest_solids + random.below(options.most_solids - options.fewest_solids + 1);
    std::vector<int> priorities(std::size_t(count), 0);
    for (int i = 0; i < count; ++i) priorities[std::size_t(i)] = i;
    for (int i = count - 1; i > 0; --i)
        std::swap(priorities[std::size_t(i)], priorities[std::size_t(random.below(i + 1))]);

    bool has_half_space = false;
    for (const int priority : priorities) {
        const geom::Vec3 center = random.lattice_point(-1.5, 1.5);
        const bool own_origin = options.rotated || options.stretched;
        geom::Vec3 origin = own_origin ? random.lattice_point(-2.0, 2.0) : geom::Vec3{0.0};
        geom::Vec3 stretch{1.0};
        geom::Shape shape;
        if (!has_half_space && random.chance(0.08)) {
            has_half_space = true;
            origin = geom::Vec3{0.0};
            shape = random_half_space(random);
        } else {
            const RandomShape first = random_shape(random, options, center - origin);
            shape = first.shape;
            if (first.at_origin) origin = center;
            if (auto* box = std::get_if<geom::Box>(&shape); box && options.stretched) {
                for (int axis = 0; axis < 3; ++axis) {
                    const double factors[] = {0.125, 0.25, 0.5, 1.0, 3.0, 10.0};
                    stretch[axis] = factors[random.below(6)];
                }
                box->corner1 /= stretch;
                box->corner2 /= stretch;
            } else if (auto* ball = std::get_if<geom::Sphere>(&shape); ball && options.stretched) {
                stretch = geom::Vec3{random.chance(0.5) ? 0.25 : 3.0};
                ball->center /= stretch.x;
                ball->radius /= stretch.x;
            }
        }
        const Medium& drawn = media[std::size_t(random.below(int(media.size())))];
        const auto interior = SceneBuilder::medium(drawn.ior, priority + 1, drawn.absorption);
        const auto transform = place(origin, stretch);
        if (options.opaque_members && random.chance(0.15)) {
            scene::Texture texture;
            texture.pigment = plain({random.point(0.2, 1.0)});
            scene::Interior hidden;
            hidden.priority = priority + 1;
            hidden.states_priority = true;
            builder.solid(shape, hidden, texture, transform);
        } else if (options.textured && random.chance(0.4)) {
            builder.solid(shape, interior, random_skin(random), transform);
        } else {
            builder.solid(shape, interior, scene::Texture::clear_skin(), transform);
        }
        if (options.unions && random.chance(0.25)) {
            const geom::Vec3 beside = random.lattice_point(-1.5, 1.5);
            const RandomShape second = random_shape(random, options, geom::Vec3{0.0});
            builder.united_with(second.shape, place(beside, geom::Vec3{1.0}));
        } else if (options.complements && random.chance(0.1)) {
            builder.inverse();
        }
    }

    if (options.floor && random.chance(0.7)) {
        scene::Finish finish;
        finish.ambient = scene::Rgb{0.2};
        auto tiles = checker(random.point(0.0, 0.4), random.point(0.6, 1.0));
        tiles.transform = geom::Transform::translation({0.0, 0.25, 0.0});  // off the lattice
        builder.opaque(geom::Plane{{0.0, 1.0, 0.0}, random.lattice(-3.0, -1.5)}, tiles, finish,
                       place(geom::Vec3{0.0}, geom::Vec3{1.0}));
        builder.lamp(whole.point(rotation.point(random.point(2.0, 5.0))), scene::Rgb{0.7});
    }
    if (random.chance(0.4)) {  // a shining ball: it touches nothing, so it is nobody's equal
        scene::Finish finish;
        finish.ambient = scene::Rgb{0.0};
        finish.diffuse = 0.0;
        finish.emission = random.point(0.2, 1.0);
        builder.opaque(geom::Sphere{random.point(-1.2, 1.2), 0.31}, plain({scene::Rgb{1.0}}),
                       finish, place(geom::Vec3{0.0}, geom::Vec3{1.0}));
    }
    builder.sky(random.point(0.0, 0.5), random.point(0.5, 1.0));

    const bool within = random.chance(0.25);
    const geom::Vec3 direction =
        glm::normalize(random.point(-1.0, 1.0) + geom::Vec3{0.0, 0.3, 0.0});
    const geom::Vec3 location =
        within ? random.point(-1.5, 1.5) : random.between(5.0, 7.0) * direction;
    const geom::Vec3 target = random.point(-0.3, 0.3);
    builder.camera(whole.point(rotation.point(location)), whole.point(rotation.point(target)),
                   within ? 90.0 : 45.0);
    if (options.scale != 1.0) {
        for (scene::Solid& solid : builder.scene().solids)
            solid.interior.absorption /= options.scale;
    }
    return builder.scene();
}

double contact_of(const RandomSceneOptions& options) {
    return 3e-14 * options.scale + 4e-15 * geom::max_abs(options.offset);
}

}  // namespace meniscus::oracle
