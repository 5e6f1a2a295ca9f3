// What a scene does not need, found out when it is compiled: it costs nothing and is told.

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "compare/metrics.hpp"
#include "tests/random/random.hpp"
#include "tests/tracer/scenes.hpp"
#include "tests/tracer/shortcut.hpp"
#include "tracer/hidden.hpp"

using namespace meniscus;
using namespace meniscus::test;
using tracer::Hidden;

namespace {

/// A glass ball of priority 2.
scene::Scene paperweight() {
    scene::Scene scene;
    look(scene, {0.7, 1.0, -5.0});
    scene.background.rgb = scene::Rgb{0.5, 0.6, 0.9};
    add_glass(scene, geom::Sphere{Vec3{0.0}, 1.0}, 1.5, 2.0);
    return scene;
}

geom::Mesh mesh(geom::TriangleSoup soup) {
    return {std::make_shared<const geom::TriangleMesh>(std::move(soup))};
}

/// A torus of triangles.
geom::TriangleSoup ring(double major, double minor) {
    constexpr std::uint32_t around = 48, across = 24;
    geom::TriangleSoup soup;
    const auto turn = [](std::uint32_t i, std::uint32_t of) { return 6.283185307179586 * i / of; };
    const auto at = [](std::uint32_t i, std::uint32_t j) {
        return (i % around) * across + j % across;
    };
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t j = 0; j < across; ++j) {
            const double a = turn(i, around), b = turn(j, across);
            const double r = major + minor * std::cos(b);
            soup.positions.push_back({r * std::cos(a), minor * std::sin(b), r * std::sin(a)});
            soup.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    return soup;
}

std::size_t left_out(const scene::Scene& scene) {
    return scene.objects.size() - tracer::compile(scene, Hidden::left_out).parts.size();
}

}  // namespace

TEST_CASE("what is hidden in stronger solids is left out and no picture changes", "[tracer]") {
    const auto kernel = GENERATE(tracer::Kernel::general, tracer::Kernel::automatic);
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        Random random(seed);
        auto scene = paperweight();
        add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
                   matte(checker(scene::Rgb{0.2}, scene::Rgb{0.9})));
        scene::Light light;
        light.position = {3.0, 5.0, -4.0};
        light.color = scene::Rgb{1.0};
        scene.lights.push_back(light);
        add_glass(scene, geom::Box{{0.3, -1.0, -1.5}, {1.8, 0.5, 1.0}}, 1.3, 1.0);
        // In the ball, in the box, in both or neither.
        for (int i = 0; i < 40; ++i)
            add_glass(scene, geom::Sphere{random.point(-1.5, 1.5), random.between(0.05, 0.2)}, 1.2,
                      i % 4 == 0 ? 1.5 : 0.0, scene::Rgb{i % 3 == 0 ? 0.5 : 0.0});
        const auto all = tracer::compile(scene);
        const auto seen = tracer::compile(scene, Hidden::left_out);
        INFO("seed " << seed << ", " << seen.parts.size() << " of " << all.parts.size());
        REQUIRE(all.parts.size() == scene.objects.size());
        CHECK(seen.parts.size() + 3 < all.parts.size());
        CHECK(seen.parts.size() > 3);
        CHECK(seen.size == all.size);
        const auto with = tracer::render(all, full_trees(kernel));
        const auto without = tracer::render(seen, full_trees(kernel));
        CHECK(compare::measure(with.picture, without.picture, 0.0).largest == 0.0);
        CHECK(without.statistics.segments == with.statistics.segments);
        CHECK(without.statistics.true_crossings == with.statistics.true_crossings);
        CHECK(without.statistics.false_crossings < with.statistics.false_crossings);
        CHECK(with.statistics.leaks + without.statistics.leaks == 0);
    }
}

TEST_CASE("a ball hidden in a stronger one costs no crossing, and it is told", "[tracer]") {
    auto scene = paperweight();
    const auto alone = tracer::render(tracer::compile(scene), full_trees(tracer::Kernel::general));
    add_glass(scene, geom::Sphere{{0.1, 0.0, 0.0}, 0.5}, 1.3, 1.0, scene::Rgb{0.5});
    const auto seen = tracer::compile(scene, Hidden::left_out);
    CHECK(seen.parts.size() == 1);
    CHECK_FALSE(seen.has_attenuation);
    CHECK(std::ranges::count(seen.skipped, "hidden inside of what is stronger: 1 of 2 shapes") ==
          1);
    const auto found = tracer::render(seen, full_trees(tracer::Kernel::general)).statistics;
    CHECK(found.casts == alone.statistics.casts);
    CHECK(found.false_crossings == 0);
    const auto kept =
        tracer::render(tracer::compile(scene), full_trees(tracer::Kernel::general)).statistics;
    CHECK(kept.false_crossings > 0);
}

TEST_CASE("what may be seen is not left out", "[tracer]") {
    const auto with = [](const geom::Shape& shape, double priority, auto&& change) {
        auto scene = paperweight();
        auto& inner = add_glass(scene, shape, 1.3, priority);
        change(scene.objects[0], inner);
        return left_out(scene);
    };
    const auto nothing = [](scene::Object&, scene::Object&) {};
    const geom::Sphere ball{{0.1, 0.0, 0.0}, 0.5};
    CHECK(with(ball, 1.0, nothing) == 1);
    CHECK(with(ball, 2.0, nothing) == 0);
    CHECK(with(ball, 3.0, nothing) == 0);
    CHECK(with(geom::Sphere{{0.6, 0.0, 0.0}, 0.5}, 1.0, nothing) == 0);  // sticks out
    CHECK(with(geom::Sphere{{0.5, 0.0, 0.0}, 0.5}, 1.0, nothing) == 0);  // touches
    CHECK(with(ball, 1.0, [](scene::Object& outer, auto&) { outer.no_shadow = true; }) == 0);
    CHECK(with(ball, 1.0, [](scene::Object& outer, auto&) { outer.no_image = true; }) == 0);
    CHECK(with(ball, 1.0, [](scene::Object& outer, auto&) { outer.no_reflection = true; }) == 0);
    CHECK(with(ball, 1.0, [](scene::Object& outer, auto&) { outer.inverse = true; }) == 0);
    CHECK(with(ball, 1.0, [](auto&, scene::Object& inner) { inner.inverse = true; }) == 0);
    CHECK(with(ball, 1.0, [](auto&, scene::Object& inner) { inner.no_shadow = true; }) == 1);
    CHECK(with(geom::Torus{0.5, 0.2}, 1.0, nothing) == 1);
    CHECK(with(geom::Torus{0.5, 0.6}, 1.0, nothing) == 0);

    auto opaque = paperweight();  // its surface is always met
    add_opaque(opaque, ball, matte(plain(scene::Rgb{0.5})));
    CHECK(left_out(opaque) == 0);
    auto open = paperweight();  // a disc is no solid
    add_glass(open, geom::Disc{Vec3{0.0}, {0.0, 1.0, 0.0}, 0.5, 0.0}, 1.3, 1.0);
    CHECK(left_out(open) == 0);
}

TEST_CASE("half-spaces hide too, and of a union each shape may be hidden", "[tracer]") {
    scene::Scene scene;
    add_glass(scene, geom::Plane{{0.0, 1.0, 0.0}, 0.0}, 1.33, 2.0);
    add_glass(scene, geom::Sphere{{0.0, -2.0, 0.0}, 1.0}, 1.3, 1.0);
    add_glass(scene, geom::Sphere{{0.0, 2.0, 0.0}, 1.0}, 1.3, 1.0);
    scene.objects[2].solid = scene.objects[1].solid;
    const auto seen = tracer::compile(scene, Hidden::left_out);
    REQUIRE(seen.parts.size() == 2);
    CHECK(seen.parts[1].object == 2);
}

TEST_CASE("meshes inside of stronger meshes are left out", "[tracer]") {
    const auto with = [](const geom::TriangleSoup& outer, const geom::TriangleSoup& inner,
                         const geom::Transform& placed = {}) {
        scene::Scene scene;
        look(scene, {0.7, 2.0, -4.0});
        scene.background.rgb = scene::Rgb{0.5, 0.6, 0.9};
        add_opaque(scene, geom::Plane{{0.0, 1.0, 0.0}, -1.0},
                   matte(checker(scene::Rgb{0.2}, scene::Rgb{0.9})));
        add_glass(scene, mesh(outer), 1.5, 2.0);
        add_glass(scene, mesh(inner), 1.3, 1.0).transform = placed;
        return scene;
    };
    const auto scene = with(ring(1.0, 0.4), ring(1.0, 0.25));
    REQUIRE(left_out(scene) == 1);
    const auto options = full_trees(tracer::Kernel::general);
    const auto kept = tracer::render(tracer::compile(scene), options);
    const auto seen = tracer::render(tracer::compile(scene, Hidden::left_out), options);
    CHECK(compare::measure(kept.picture, seen.picture, 0.0).largest == 0.0);
    CHECK(seen.statistics.true_crossings == kept.statistics.true_crossings);
    CHECK(kept.statistics.false_crossings > 0);
    CHECK(seen.statistics.false_crossings == 0);

    CHECK(left_out(with(ring(1.0, 0.4), ring(1.0, 0.4))) == 0);
    CHECK(left_out(with(ring(1.0, 0.4), ring(0.4, 0.1))) == 0);  // in its hole
    CHECK(left_out(with(ring(1.0, 0.4), ring(1.0, 0.25),
                        geom::Transform::translation({0.3, 0.0, 0.0}))) == 0);
    CHECK(left_out(with(ring(2.0, 0.8), ring(1.0, 0.25), geom::Transform::scaling(Vec3{2.0}))) ==
          1);
    CHECK(left_out(with(ring(1.0, 0.25), ring(1.0, 0.4))) == 0);
    // In a ball by the box around the mesh, whose corners may stick out where the mesh does not.
    const auto in_ball = [&](double radius) {
        auto scene = with(ring(1.0, 0.4), ring(1.0, 0.25));
        scene.objects[1].shape = geom::Sphere{Vec3{0.0}, radius};
        return left_out(scene);
    };
    CHECK(in_ball(1.8) == 1);
    CHECK(in_ball(1.3) == 0);
    CHECK(in_ball(1.0) == 0);
    // A hollow of the outer one within the inner one, which shows the hollow's medium.
    auto hollow = ring(1.0, 0.6);
    const auto cavity = ring(1.0, 0.1);
    for (const auto& [i, j, k] : cavity.triangles) {
        const auto first = std::uint32_t(ring(1.0, 0.6).positions.size());
        hollow.triangles.push_back({i + first, k + first, j + first});
    }
    for (const Vec3& p : cavity.positions) hollow.positions.push_back(p);
    CHECK(left_out(with(hollow, ring(1.0, 0.3))) == 0);
}

TEST_CASE("where no dielectrics meet that is told, and nothing false is crossed", "[tracer]") {
    const auto told = [](const scene::Scene& scene) {
        const auto compiled = tracer::compile(scene);
        return std::ranges::count(compiled.skipped,
                                  "no dielectrics that meet: no priorities to compare") == 1;
    };
    auto scene = paperweight();
    add_glass(scene, geom::Sphere{{3.0, 0.0, 0.0}, 1.0}, 1.3, 1.0);
    CHECK(told(scene));
    const auto found =
        tracer::render(tracer::compile(scene), full_trees(tracer::Kernel::general)).statistics;
    CHECK(found.true_crossings > 100);
    CHECK(found.false_crossings == 0);
    scene.objects[1].shape = geom::Sphere{{2.0, 0.0, 0.0}, 1.0};
    CHECK_FALSE(told(scene));
    scene.objects[1].shape = geom::Plane{{0.0, 1.0, 0.0}, -3.0};
    CHECK_FALSE(told(scene));
}

TEST_CASE("a camera in no solid needs no search for its list", "[tracer]") {
    const auto is_clear = [](const geom::Shape& shape, const Vec3& from, bool inverse = false) {
        scene::Scene scene;
        look(scene, from);
        add_glass(scene, shape, 1.5, 1.0).inverse = inverse;
        return tracer::compile(scene).is_camera_clear;
    };
    const geom::Sphere ball{Vec3{0.0}, 1.0};
    const geom::Plane ground{{0.0, 1.0, 0.0}, 0.0};
    CHECK(is_clear(ball, {0.0, 0.0, -5.0}));
    CHECK_FALSE(is_clear(ball, {0.0, 0.0, -0.5}));
    CHECK_FALSE(is_clear(ball, {0.0, 0.0, -1.0}));
    CHECK_FALSE(is_clear(ball, {0.0, 0.0, -5.0}, true));
    CHECK(is_clear(ground, {0.0, 1.0, -5.0}));
    CHECK_FALSE(is_clear(ground, {0.0, 0.0, -5.0}));
    CHECK_FALSE(is_clear(ground, {0.0, -1.0, -5.0}));

    auto scene = paperweight();
    add_glass(scene, geom::Plane{{0.0, 1.0, 0.0}, -0.5}, 1.33, 1.0);
    check_shortcut(tracer::compile(scene),
                   [](tracer::RenderScene& known) { known.is_camera_clear = false; });
}

TEST_CASE("between like media there is no surface to reflect", "[tracer]") {
    const auto kernel = GENERATE(tracer::Kernel::general, tracer::Kernel::automatic);
    const auto count = [&](double inner_ior) {
        auto scene = paperweight();
        add_glass(scene, geom::Sphere{{0.1, 0.0, 0.0}, 0.5}, inner_ior, 3.0);
        return tracer::render(tracer::compile(scene), full_trees(kernel)).statistics;
    };
    const auto alone =
        tracer::render(tracer::compile(paperweight()), full_trees(kernel)).statistics;
    const auto alike = count(1.5), unlike = count(1.3);
    CHECK(alike.reflected_rays == alone.reflected_rays);
    CHECK(alike.refracted_rays == alone.refracted_rays);
    CHECK(unlike.reflected_rays > alone.reflected_rays);
}

TEST_CASE("without lights there are no shadow rays, without dielectrics no lists", "[tracer]") {
    const auto told = [](const tracer::RenderScene& scene, std::string_view what) {
        return std::ranges::any_of(scene.skipped,
                                   [&](const std::string& text) { return text.starts_with(what); });
    };
    scene::Scene source;
    look(source, {0.7, 1.0, -5.0});
    add_opaque(source, geom::Sphere{Vec3{0.0}, 1.0}, matte(plain(scene::Rgb{0.7})));
    add_opaque(source, geom::Box{{0.5, -1.0, -1.0}, {2.0, 0.5, 1.0}},
               matte(plain(scene::Rgb{0.7, 0.3, 0.2})));
    const auto dark = tracer::compile(source);
    CHECK(told(dark, "no light: no shadow rays"));
    CHECK(told(dark, "no dielectric: no interior lists"));
    CHECK(told(dark, "no absorption: no exponentials"));
    scene::Light light;
    light.position = {3.0, 5.0, -4.0};
    light.color = scene::Rgb{1.0};
    source.lights.push_back(light);
    const auto lit = tracer::compile(source);
    CHECK_FALSE(told(lit, "no light"));
    auto options = full_trees(tracer::Kernel::general);
    CHECK(tracer::render(dark, options).statistics.shadow_rays == 0);
    const auto swept = tracer::render(lit, options).statistics;
    CHECK(swept.shadow_rays > 100);
    CHECK(swept.false_crossings == 0);
    options.interior = tracer::InteriorMode::off;
    CHECK(tracer::render(lit, options).statistics.casts == swept.casts);
    add_glass(source, geom::Sphere{{0.0, 0.0, -2.0}, 0.3}, 1.5, 1.0, scene::Rgb{0.5});
    const auto with_glass = tracer::compile(source);
    CHECK_FALSE(told(with_glass, "no dielectric:"));
    CHECK_FALSE(told(with_glass, "no absorption"));
}
