#include <catch2/catch.hpp>

#include "geom/placed_shape.hpp"
#include "tests/geom/lines.hpp"

// What every shape promises, asked of the default value of each member of Shape, as it is and moved
// about.

namespace meniscus::geom {

namespace {

std::vector<Transform> placements() {
    return {
        Transform{},
        Transform::translation({0.5, -0.25, 2.0}),
        Transform::rotation_degrees({0.0, 90.0, 0.0}),
        Transform::rotation_degrees({20.0, -35.0, 70.0}).then(Transform::translation({3, 1, -2})),
        Transform::scaling({2.0, 0.5, 1.25}).then(Transform::rotation_degrees({10, 20, 30})),
        Transform::scaling({-1.0, 1.0, 1.0})};
}

/// World lines that are awkward in the shape's own frame.
Ray placed(const Ray& line, const Transform& transform) {
    const Vec3 d = glm::normalize(transform.vector(line.direction));
    return {transform.point(line.origin), d};
}

/// u M of the law of errors, with room to spare.
double rounding(const PlacedShape& shape, const Ray& ray, double t) {
    const double condition = 64.0;
    return condition * unit_roundoff *
           (max_abs(ray.origin) + glm::abs(t) + shape.magnitude() + 1.0);
}

Crossings surface_of(const PlacedShape& shape, const Ray& ray) {
    Crossings result;
    if (shape.is_closed()) {
        shape.crossings(ray, result);
    } else {
        shape.hits(ray, result);
    }
    return result;
}

bool is_near_surface(const PlacedShape& shape, const Vec3& p) {
    Dice dice(1);
    const double step = 1e-9 * (1.0 + max_abs(p));
    const bool inside = shape.contains(p);
    for (int i = 0; i < 16; ++i) {
        if (shape.contains(p + step * dice.direction()) != inside) return true;
    }
    return false;
}

template <class Visit>
void for_each_line(const Shape& unit_shape, int count, Visit&& visit) {
    for (const Transform& transform : placements()) {
        const PlacedShape shape(unit_shape, transform);
        for (const Ray& line : awkward_lines(count)) {
            const Ray ray = placed(line, transform);
            visit(shape, ray, surface_of(shape, ray));
        }
    }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("crossings are sorted, take turns and balance", "[geom][contract]", Shape) {
    for_each_line(TestType{}, 2000,
                  [](const PlacedShape& shape, const Ray&, const Crossings& found) {
                      bool sorted = true, alternate = true;
                      for (std::size_t i = 1; i < found.size(); ++i) {
                          sorted &= found[i - 1].t <= found[i].t;
                          alternate &= found[i - 1].entering != found[i].entering;
                      }
                      REQUIRE(sorted);
                      if (!shape.is_closed()) return;
                      REQUIRE(alternate);
                      if (shape.bounds().is_finite()) {
                          REQUIRE(found.size() % 2 == 0);
                          REQUIRE((found.empty() || found[0].entering));
                      }
                  });
}

TEMPLATE_LIST_TEST_CASE("between entering and leaving a line is inside", "[geom][contract]",
                        Shape) {
    for_each_line(
        TestType{}, 1000, [](const PlacedShape& shape, const Ray& ray, const Crossings& found) {
            if (!shape.is_closed()) return;
            for (std::size_t i = 0; i <= found.size(); ++i) {
                const double from =
                    i == 0 ? (found.empty() ? -8.0 : found[0].t - 1.0) : found[i - 1].t;
                const double to = i == found.size() ? from + 1.0 : found[i].t;
                if (to - from < 1e-5 || glm::abs(from) > 1e6) continue;
                const Vec3 p = ray.at(0.5 * (from + to));
                if (is_near_surface(shape, p)) continue;  // runs within a face: a matter of taste
                bool inside = i > 0 && found[i - 1].entering;
                if (found.empty() && !shape.bounds().is_finite()) continue;
                if (!found.empty() && i == 0) inside = !found[0].entering;
                INFO("t " << from << " to " << to << ", p " << p.x << ' ' << p.y << ' ' << p.z);
                REQUIRE(shape.contains(p) == inside);
                REQUIRE((shape.depth_at(p) > 0) == inside);
            }
        });
}

TEMPLATE_LIST_TEST_CASE("normals are unit vectors and look back where a line enters",
                        "[geom][contract]", Shape) {
    for_each_line(
        TestType{}, 2000, [](const PlacedShape& shape, const Ray& ray, const Crossings& found) {
            for (const Crossing& crossing : found) {
                const Vec3 n = shape.normal(crossing.face, ray.at(crossing.t));
                REQUIRE(glm::length(n) == Approx(1.0).epsilon(1e-14));
                const double slope = glm::dot(n, ray.direction);
                if (glm::abs(slope) > 1e-6) REQUIRE((slope < 0.0) == crossing.entering);
                const Vec3 shading = shape.shading_normal(crossing.face, ray.at(crossing.t));
                REQUIRE(glm::length(shading) == Approx(1.0).epsilon(1e-14));
                REQUIRE(glm::dot(shading, n) > 0.0);
            }
        });
}

TEMPLATE_LIST_TEST_CASE("the bounds hold every crossing", "[geom][contract]", Shape) {
    for_each_line(TestType{}, 2000,
                  [](const PlacedShape& shape, const Ray& ray, const Crossings& found) {
                      for (const Crossing& crossing : found) {
                          const double margin = rounding(shape, ray, crossing.t);
                          REQUIRE(shape.bounds().padded(margin).contains(ray.at(crossing.t)));
                      }
                  });
}

TEMPLATE_LIST_TEST_CASE("a crossing obeys the law of errors along the normal", "[geom][contract]",
                        Shape) {
    for_each_line(
        TestType{}, 2000, [](const PlacedShape& shape, const Ray& ray, const Crossings& found) {
            for (const Crossing& crossing : found) {
                const Vec3 p = ray.at(crossing.t), q = shape.on_face(crossing.face, p);
                const double error = glm::length(q - p), bound = rounding(shape, ray, crossing.t);
                INFO("error " << error << " of " << bound << ", t " << crossing.t << ", face "
                              << crossing.face);
                REQUIRE(error <= bound);
                // Putting it back twice is as good as once.
                const Vec3 again = shape.on_face(crossing.face, q);
                REQUIRE(glm::length(again - q) <= 0.25 * bound);
            }
        });
}

TEMPLATE_LIST_TEST_CASE("the root of a pinned face is exactly 0", "[geom][contract]", Shape) {
    Dice dice(7);
    for_each_line(TestType{}, 500,
                  [&](const PlacedShape& shape, const Ray& ray, const Crossings& found) {
                      if (!shape.is_convex()) return;
                      for (const Crossing& crossing : found) {
                          const Vec3 p = shape.on_face(crossing.face, ray.at(crossing.t));
                          const Vec3 d = dice.direction(), n = shape.normal(crossing.face, p);
                          const double slope = glm::dot(n, d);
                          if (glm::abs(slope) < 1e-6) continue;
                          // Where another face is as near, either may come first.
                          const Vec3 inward = p - 1e-6 * n;
                          if (!shape.contains(inward) || !shape.contains(inward + 0.9e-6 * d) ||
                              !shape.contains(inward - 0.9e-6 * d)) {
                              continue;
                          }
                          const Interval interval = shape.interval({p, d}, crossing.face);
                          if (interval.t1 - interval.t0 < 1e-6) continue;  // in a corner
                          INFO("face " << crossing.face << ", slope " << slope << ", t0 "
                                       << interval.t0 << ", t1 " << interval.t1);
                          REQUIRE((slope < 0.0 ? interval.t0 : interval.t1) == 0.0);
                          REQUIRE((slope < 0.0 ? interval.face0 : interval.face1) == crossing.face);
                      }
                  });
}

TEMPLATE_LIST_TEST_CASE("a ray from inside a convex solid leaves it", "[geom][contract]", Shape) {
    Dice dice(11);
    for (const Transform& transform : placements()) {
        const PlacedShape shape(Shape{TestType{}}, transform);
        if (!shape.is_convex()) continue;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 p = transform.point(dice.point(1.0));
            if (!shape.contains(p)) continue;
            const Interval interval = shape.interval({p, dice.direction()}, no_face);
            REQUIRE(interval.t1 >= -1e-14);
            REQUIRE(interval.t0 <= 1e-14);
        }
    }
}

}  // namespace meniscus::geom
