// Two surfaces a little apart: the exact picture of the film between them, down to the contact
// tolerance, and below it the exact picture of contact.

#include <catch2/catch.hpp>

#include "tests/oracle/compare.hpp"
#include "tests/oracle/scene_builder.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

enum class Kind { spheres, cylinders, lathes, funnels, turned_boxes, boxes };

/// Water, around it a film of air of thickness h, around that glass.
scene::Scene with_film(Kind kind, double h, double offset) {
    const geom::Vec3 c{offset};
    SceneBuilder builder;
    builder.camera(c + geom::Vec3{0.5, 0.75, -5.0}, c + geom::Vec3{0.03125, 0.0, 0.0}, 30.0)
        .sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7});
    const auto add = [&](const geom::Shape& water, const geom::Shape& air, const geom::Shape& glass,
                         const geom::Transform& place = {}) {
        if (h != 0.0) builder.glass(air, 1.0, 2, scene::Rgb{0.0}, place);
        builder.glass(water, 1.33, 3, scene::Rgb{0.0}, place)
            .glass(glass, 1.5, 1, scene::Rgb{0.0}, place);
    };
    switch (kind) {
        case Kind::spheres:
            add(geom::Sphere{c, 0.75}, geom::Sphere{c, 0.75 + h}, geom::Sphere{c, 1.0});
            break;
        case Kind::cylinders: {
            const auto round = [&](double r) {
                return geom::Cylinder{c - geom::Vec3{0, 1, 0}, c + geom::Vec3{0, 1, 0}, r, false};
            };
            add(round(0.75), round(0.75 + h), round(1.0));
            break;
        }
        case Kind::lathes: {
            const auto turned = [&](double r) {
                return geom::Lathe(geom::Spline::linear,
                                   {{0.0, -1.0}, {r, -1.0}, {r, 1.0}, {0.0, 1.0}});
            };
            add(turned(0.75), turned(0.75 + h), turned(1.0), geom::Transform::translation(c));
            break;
        }
        case Kind::funnels: {
            const auto turned = [&](double r) {
                return geom::Lathe(geom::Spline::linear,
                                   {{0.0, -1.0}, {r - 0.25, -1.0}, {r, 1.0}, {0.0, 1.0}});
            };
            add(turned(0.75), turned(0.75 + h), turned(1.0), geom::Transform::translation(c));
            break;
        }
        case Kind::turned_boxes: {
            const auto slab = [](double from, double to) {
                return geom::Box{{-1.0, -1.0, from}, {1.0, 1.0, to}};
            };
            add(slab(-0.5, 0.0), slab(0.0, h), slab(0.0, 0.5),
                geom::Transform::rotation_degrees({10.0, 20.0, 30.0})
                    .then(geom::Transform::translation(c)));
            break;
        }
        case Kind::boxes:
            add(geom::Box{c - geom::Vec3{1.0, 1.0, 0.5}, c + geom::Vec3{1.0, 1.0, 0.0}},
                geom::Box{c - geom::Vec3{1.0, 1.0, 0.0}, c + geom::Vec3{1.0, 1.0, h}},
                geom::Box{c - geom::Vec3{1.0, 1.0, 0.0}, c + geom::Vec3{1.0, 1.0, 0.5}});
            break;
    }
    return builder.scene();
}

/// Pixels of the picture with a film of thickness h that differ from those of the exact scene
/// `truth`.
std::size_t off(Kind kind, double h, double offset, double truth) {
    Picture picture{.width = 24, .height = 18, .limits = {.depth = 6, .cutoff = 1e-2}};
    picture.limits.contact = 1e-18;
    const auto difference = compare<Quad>(rendered(with_film(kind, h, offset), picture),
                                          with_film(kind, truth, offset), picture);
    INFO(difference.text());
    CHECK(difference.leaks == 0);
    return difference.off;
}

}  // namespace

TEST_CASE("a film is a film and contact is contact", "[oracle][film]") {
    const Kind kind = GENERATE(Kind::spheres, Kind::cylinders, Kind::boxes);
    CAPTURE(int(kind));
    for (const double h : {1e-3, 1e-6, 1e-9, 1e-12, 1e-13, 3e-14}) {
        CAPTURE(h);
        CHECK(off(kind, h, 0.0, h) == 0);
    }
    CHECK(off(kind, 0.0, 0.0, 0.0) == 0);
    CHECK(off(kind, 1e-15, 0.0, 0.0) == 0);
}

TEST_CASE("far from the origin films about one centre or axis stay apart as at it",
          "[oracle][film]") {
    const Kind kind = GENERATE(Kind::spheres, Kind::cylinders);
    const double offset = GENERATE(1024.0, 1048576.0);
    CAPTURE(int(kind), offset);
    for (const double h : {1e-9, 1e-11, 3e-14}) {
        CAPTURE(h);
        CHECK(off(kind, h, offset, h) == 0);
    }
    CHECK(off(kind, 1e-15, offset, 0.0) == 0);
}

TEST_CASE("far from the origin films in one frame stay apart", "[oracle][film]") {
    const Kind kind = GENERATE(Kind::lathes, Kind::funnels, Kind::turned_boxes);
    const double offset = GENERATE(1024.0, 1048576.0);
    CAPTURE(int(kind), offset);
    CHECK(off(kind, 1e-12, offset, 1e-12) == 0);
    CHECK(off(kind, 1e-15, offset, 0.0) == 0);
}

TEST_CASE("far from the origin coordinates hold no thinner films between boxes", "[oracle][film]") {
    CHECK(off(Kind::boxes, 1e-11, 1024.0, 1e-11) == 0);
    CHECK(off(Kind::boxes, 1e-12, 1024.0, 0.0) == 0);
    CHECK(off(Kind::boxes, 1e-8, 1048576.0, 1e-8) == 0);
    CHECK(off(Kind::boxes, 1e-9, 1048576.0, 0.0) == 0);
}
