#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "geom/placed_shape.hpp"
#include "tests/geom/lines.hpp"
#include "tests/geom/meshes.hpp"

// Rays that leave a surface do not meet it again, and stay on it however often they return.

namespace meniscus::geom {

namespace {

/// A coordinate between 1e-8 and 1e8, of either sign.
double wild(Dice& dice) {
    return (dice.below(2) == 0 ? 1.0 : -1.0) * std::pow(10.0, dice.between(-8.0, 8.0));
}
Vec3 wild_point(Dice& dice) { return {wild(dice), wild(dice), wild(dice)}; }

Shape wild_shape(int kind, Dice& dice) {
    switch (kind) {
        case 0:
            return Sphere{wild_point(dice), std::fabs(wild(dice))};
        case 1:
            return Box{wild_point(dice), wild_point(dice)};
        case 2:
            return Cylinder{wild_point(dice), wild_point(dice), std::fabs(wild(dice))};
        case 3:
            return Plane{dice.direction(), wild(dice)};
        default:
            return Cone{wild_point(dice), std::fabs(wild(dice)), wild_point(dice),
                        dice.below(2) == 0 ? 0.0 : std::fabs(wild(dice))};
    }
}

/// Shapes whose crossings come as a list. Lathes and meshes are convex here, so that no ray that
/// leaves them may return.
PlacedShape wild_general_shape(int kind, Dice& dice) {
    const double size = std::fabs(wild(dice)), other = std::fabs(wild(dice));
    const Transform shift = Transform::translation(wild_point(dice));
    const auto mesh = [](TriangleSoup soup) {
        return Mesh{std::make_shared<const TriangleMesh>(std::move(soup))};
    };
    switch (kind) {
        case 0:  // with a hole
            return {Torus{size, std::fmin(other, size * dice.between(0.01, 0.9))}, shift};
        case 1:
            return {Lathe{Spline::linear,
                          {{0, 0}, {size, 0}, {std::fabs(wild(dice)), other}, {0, other}}},
                    shift};
        case 2:
            return {Lathe{Spline::bezier, {{0, 0}, {size, 0}, {size, other}, {0, other}}}, shift};
        case 3:
            return {mesh(gridded_box(2, wild_point(dice), wild_point(dice))), Transform{}};
        default:
            return {mesh(icosphere(2, size, wild_point(dice))), Transform{}};
    }
}

/// A point of the surface, and a face that it is on: where a line through the middle of the bounds
/// arrives.
struct Footing {
    Vec3 p;
    Face face;
};
std::optional<Footing> footing(const PlacedShape& shape, Dice& dice) {
    const Bounds box = shape.bounds().is_finite() ? shape.bounds() : Bounds{Vec3{-1.0}, Vec3{1.0}};
    const Vec3 d = dice.direction();
    const Vec3 target =
        box.low +
        Vec3{dice.between(0.3, 0.7), dice.between(0.3, 0.7), dice.between(0.3, 0.7)} * box.size();
    const Ray ray{target - 2.0 * max_abs(box.size()) * d, d};
    Crossings found;
    shape.crossings(ray, found);
    if (found.empty()) return std::nullopt;
    return Footing{shape.on_face(found[0].face, ray.at(found[0].t)), found[0].face};
}

Vec3 leaving_direction(const Vec3& n, Dice& dice) {
    const Vec3 d = dice.direction();
    const double slope = glm::dot(d, n);
    return slope < 0.0 ? d - 2.0 * slope * n : d;
}

/// How thick the solid is, along its normals, where a ray that leaves it meets it again nearer than
/// `free`; in units of the contact tolerance, below which the tracer takes a chord for a touch.
double met_again_in_tolerances(const PlacedShape& shape, const Ray& ray, double free) {
    Crossings found;
    shape.crossings(ray, found);
    double inside_since = 0.0, cosine_there = 0.0, worst = 0.0;
    for (const Crossing& c : found) {
        if (c.t <= 0.0) continue;
        if (c.t > free) break;
        const double cosine = std::fabs(glm::dot(ray.direction, shape.normal(c.face, ray.at(c.t))));
        if (c.entering) {
            inside_since = c.t;
            cosine_there = cosine;
        } else {
            const double thickness = (c.t - inside_since) * std::fmax(cosine_there, cosine);
            const double magnitude = max_abs(ray.origin) + c.t + shape.magnitude();
            worst = std::fmax(worst, thickness / (16.0 * unit_roundoff * magnitude));
        }
    }
    return worst;
}

/// The next reflection inside a solid: the crossing after the origin, put back on its face as the
/// tracer does it.
struct Bounce {
    const PlacedShape& shape;
    Ray ray;
    Face face = no_face;
    double worst = 0.0;  // distance from the face, in units of u M

    bool next() {
        double t = 0.0;
        if (shape.is_convex()) {
            const Interval span = shape.interval(ray, face);
            t = std::fmax(span.t1, 0.0);
            face = span.face1;
        } else {
            // The first way out beyond what belongs to the start.
            Crossings found;
            shape.crossings(ray, found);
            std::size_t i = 0;
            while (i < found.size() && (found[i].entering || found[i].t <= 1e-9)) ++i;
            if (i == found.size()) return false;
            t = found[i].t;
            face = found[i].face;
        }
        Ray point;
        const Vec3 way = ray.origin_error + t * ray.direction;
        point.origin = ray.origin + way;
        const Vec3 part = point.origin - ray.origin;
        point.origin_error = (ray.origin - (point.origin - part)) + (way - part);
        point.origin_error += shape.to_face(face, point);
        const double unit = unit_roundoff * (max_abs(ray.origin) + t + shape.magnitude());
        worst = std::fmax(worst, glm::length(shape.to_face(face, point)) / unit);
        const Vec3 n = shape.normal(face, point.origin);
        const Vec3 d = ray.direction - 2.0 * glm::dot(ray.direction, n) * n;
        ray = {point.origin, glm::normalize(d), point.origin_error};
        return true;
    }
};

}  // namespace

TEST_CASE("rays that leave a convex shape never meet it again", "[geom]") {
    for (int kind = 0; kind < 5; ++kind) {
        Dice dice(unsigned(20 + kind));
        int left = 0, met_again = 0;
        for (int s = 0; s < 1000; ++s) {
            const PlacedShape shape(wild_shape(kind, dice), Transform{});
            const auto start = footing(shape, dice);
            if (!start) continue;
            const auto [p, face] = *start;
            const Vec3 n = shape.normal(face, p);
            for (int i = 0; i < 1000; ++i) {
                const Vec3 away = leaving_direction(n, dice);
                // A convex solid lies behind all of its tangent planes; what the tracer takes for a
                // touch is no meeting.
                const Ray leaving{p, away};
                const Interval span = shape.interval(leaving, face);
                ++left;
                if (!span.hit || !(span.t1 > 0.0)) continue;
                const double chord = span.t1 - std::fmax(span.t0, 0.0);
                const double cosine =
                    std::fabs(glm::dot(away, shape.normal(span.face1, leaving.at(span.t1))));
                const double magnitude = max_abs(p) + span.t1 + shape.magnitude();
                met_again += chord * cosine > 16.0 * unit_roundoff * magnitude;
            }
        }
        INFO("kind " << kind << ", " << left << " rays");
        CHECK(left > 300000);
        CHECK(met_again == 0);
    }
}

TEST_CASE("rays that leave a torus, a lathe or a mesh do not meet it again", "[geom]") {
    for (int kind = 0; kind < 5; ++kind) {
        Dice dice(unsigned(40 + kind));
        int left = 0;
        double worst = 0.0;
        for (int s = 0; s < 1000; ++s) {
            const PlacedShape shape = wild_general_shape(kind, dice);
            const auto start = footing(shape, dice);
            if (!start) continue;
            const auto [p, face] = *start;
            const Vec3 n = shape.normal(face, p);
            for (int i = 0; i < 1000; ++i) {
                const Vec3 away = leaving_direction(n, dice);
                // A torus curves towards a ray no more than the circle of its hole does.
                const auto* torus = std::get_if<Torus>(&shape.shape());
                const double free =
                    torus ? glm::dot(away, n) * (torus->major - torus->minor) : infinity;
                ++left;
                worst = std::fmax(worst, met_again_in_tolerances(shape, {p, away}, free));
            }
        }
        INFO("kind " << kind << ", " << left << " rays");
        CHECK(left > 300000);
        // Where a mesh's vertices are rounded it is not quite convex.
        CHECK(worst <= (kind < 3 ? 1.0 : 4.0));
    }
}

TEST_CASE("ten thousand reflections stay on the surface", "[geom]") {
    const Shape shapes[] = {Sphere{}, Cylinder{{0, -1, 0}, {0.5, 1, 0.25}, 0.7}, Torus{2.0, 0.75},
                            Lathe{Spline::linear, {{0, -1}, {1, -1}, {1.25, 1}, {0, 1}}}};
    for (const Shape& unplaced : shapes) {
        for (const double offset : {0.0, 1e6}) {
            const PlacedShape shape(unplaced,
                                    Transform::translation({offset, 0.5 * offset, -offset}));
            const Vec3 inside = std::holds_alternative<Torus>(unplaced) ? Vec3{2.0, 0.1, 0.2}
                                                                        : Vec3{0.1, 0.2, 0.15};
            Bounce bounce{shape,
                          {inside + Vec3{offset, 0.5 * offset, -offset},
                           glm::normalize(Vec3{0.3, -0.8, -0.4})}};
            int bounces = 0;
            while (bounces < 10000 && bounce.next()) ++bounces;
            INFO(keyword(unplaced) << " at " << offset);
            CHECK(bounces == 10000);
            CHECK(bounce.worst <= 4.0);
            // Not only on the face: nowhere but on the solid.
            CHECK(shape.bounds().padded(1e-9 + 1e-15 * offset).contains(bounce.ray.origin));
            // With the finer origin, the offset does not count.
            Ray here = bounce.ray;
            CHECK(glm::length(shape.to_face(bounce.face, here)) <= 64.0 * unit_roundoff);
        }
    }
}

}  // namespace meniscus::geom
