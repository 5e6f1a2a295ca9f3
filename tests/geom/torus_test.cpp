#include "geom/torus.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/geom/lines.hpp"

namespace meniscus::geom {

namespace {

/// The distance from the surface, in more digits than the product has.
long double distance(const Torus& torus, const Ray& ray, long double t) {
    const long double x = ray.origin.x + t * ray.direction.x,
                      y = ray.origin.y + t * ray.direction.y,
                      z = ray.origin.z + t * ray.direction.z;
    const long double out = std::sqrt(x * x + z * z) - torus.major;
    return std::sqrt(out * out + y * y) - torus.minor;
}

}  // namespace

TEST_CASE("a line through both sides of a ring crosses it four times", "[geom]") {
    Crossings found;
    Torus{2.0, 0.5}.crossings({{-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, found);
    REQUIRE(found.size() == 4);
    const double expected[] = {2.5, 3.5, 6.5, 7.5};
    for (int i = 0; i < 4; ++i) CHECK(found[i].t == Approx(expected[i]).epsilon(1e-15));
}

TEST_CASE("the crossings of a torus are the sign changes of its distance", "[geom]") {
    for (const Torus torus :
         {Torus{1.0, 0.25}, Torus{1.0, 0.01}, Torus{0.5, 0.5}, Torus{0.3, 0.6}}) {
        for (const Ray& ray : awkward_lines(400)) {
            Crossings found;
            torus.crossings(ray, found);
            const double middle = -glm::dot(ray.origin, ray.direction);
            const int steps = 4000;
            int changes = 0;
            bool was_inside = false;
            for (int i = 0; i < steps; ++i) {
                const long double here = distance(torus, ray, middle - 2.0 + 4.0 * i / steps);
                if (std::fabs(here) < 1e-5L || (here < 0) == was_inside) continue;
                was_inside = !was_inside;
                ++changes;
            }
            INFO("torus " << torus.major << ' ' << torus.minor << " from " << ray.origin.x << ' '
                          << ray.origin.y << ' ' << ray.origin.z << " along " << ray.direction.x
                          << ' ' << ray.direction.y << ' ' << ray.direction.z);
            // Sampling may miss a thin pair, never invent one.
            REQUIRE(static_cast<int>(found.size()) >= changes);
            for (const Crossing& crossing : found) {
                const Vec3 p = ray.at(crossing.t), n = torus.normal(0, p);
                const double slope = glm::abs(glm::dot(n, ray.direction));
                const double bound =
                    32.0 * unit_roundoff * (max_abs(ray.origin) + glm::abs(crossing.t) + 2.0);
                REQUIRE(std::fabs(static_cast<double>(distance(torus, ray, crossing.t))) <= bound);
                if (slope > 1e-3) {
                    const double step = 2.0 * bound / slope;
                    const bool before = distance(torus, ray, crossing.t - step) < 0;
                    const bool after = distance(torus, ray, crossing.t + step) < 0;
                    REQUIRE(before != after);
                    REQUIRE(after == crossing.entering);
                }
            }
        }
    }
}

TEST_CASE("a torus that overlaps itself has no inner skin", "[geom]") {
    const Torus spindle{0.3, 0.6};
    CHECK(spindle.contains({0.0, 0.0, 0.0}));
    Crossings found;
    spindle.crossings({{-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, found);
    CHECK(found.size() == 2);
}

}  // namespace meniscus::geom
