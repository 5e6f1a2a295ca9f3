#include "geom/lathe.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "geom/cylinder.hpp"
#include "tests/geom/lines.hpp"

namespace meniscus::geom {

namespace {

Crossings crossings_of(const Lathe& lathe, const Ray& ray) {
    Crossings found;
    lathe.crossings(ray, found);
    return found;
}

/// radius = u, height = u^2 up to 1, with a flat lid: a bowl full to the brim.
Lathe paraboloid() {
    return {Spline::bezier,
            {{0.0, 0.0},
             {1.0 / 3.0, 0.0},
             {2.0 / 3.0, 1.0 / 3.0},
             {1.0, 1.0},
             {1.0, 1.0},
             {2.0 / 3.0, 1.0},
             {1.0 / 3.0, 1.0},
             {0.0, 1.0}}};
}

}  // namespace

TEST_CASE("a tumbler is a cylinder without a cylinder", "[geom]") {
    const Lathe tumbler;
    const Cylinder outside{{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, 1.0};
    const Cylinder hollow{{0.0, -0.75, 0.0}, {0.0, 1.0, 0.0}, 0.75};
    REQUIRE(tumbler.is_closed());
    Dice dice(1);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p = dice.point(1.2);
        REQUIRE(tumbler.contains(p) == (outside.contains(p) && !hollow.contains(p)));
    }
    for (const Ray& ray : awkward_lines(4000)) {
        const Interval a = outside.interval(ray, no_face), b = hollow.interval(ray, no_face);
        double length = a.hit ? a.t1 - a.t0 : 0.0;
        if (b.hit) length -= b.t1 - b.t0;
        // Lines within a face may go either way.
        const Vec3 d = glm::abs(ray.direction);
        if (d.x == 1.0 || d.y == 1.0 || d.z == 1.0) continue;
        double sum = 0.0;
        for (const Crossing& crossing : crossings_of(tumbler, ray)) {
            sum += crossing.entering ? -crossing.t : crossing.t;
        }
        REQUIRE(sum == Approx(length).margin(1e-6));
    }
}

TEST_CASE("a curve turned about the axis is met where algebra says", "[geom]") {
    const Lathe bowl = paraboloid();
    REQUIRE(bowl.is_closed());
    for (const Ray& ray : awkward_lines(4000)) {
        // x^2 + z^2 = y below y = 1
        const Vec3 o = ray.origin, d = ray.direction;
        const double A = d.x * d.x + d.z * d.z, B = o.x * d.x + o.z * d.z - 0.5 * d.y,
                     C = o.x * o.x + o.z * o.z - o.y, D = B * B - A * C;
        double low = -infinity, high = infinity;
        if (A > 1e-20) {
            if (D < 1e-9) continue;
            const double q = -(B + std::copysign(glm::sqrt(D), B));
            low = glm::min(q / A, C / q);
            high = glm::max(q / A, C / q);
        } else {
            low = (o.x * o.x + o.z * o.z - o.y) / d.y;
            if (d.y < 0.0) std::swap(low, high);
        }
        if (d.y > 0.0) high = glm::min(high, (1.0 - o.y) / d.y);
        if (d.y < 0.0) low = glm::max(low, (1.0 - o.y) / d.y);
        if (d.y == 0.0 && o.y >= 1.0) continue;
        const Crossings found = crossings_of(bowl, ray);
        INFO("from " << o.x << ' ' << o.y << ' ' << o.z << " along " << d.x << ' ' << d.y << ' '
                     << d.z);
        if (high - low < 1e-4) continue;
        INFO("expected " << low << ' ' << high);
        REQUIRE(found.size() == 2);
        REQUIRE(found[0].t == Approx(low).margin(1e-7));
        REQUIRE(found[1].t == Approx(high).margin(1e-7));
    }
}

TEST_CASE("a profile is a solid if it closes, alone or with the axis", "[geom]") {
    const auto closed = [](std::vector<Vec2> points) {
        return Lathe{Spline::linear, std::move(points)}.is_closed();
    };
    CHECK(closed({{0, 0}, {1, 0}, {0, 1}}));
    CHECK(closed({{1, 0}, {2, 0}, {2, 1}, {1, 0}}));
    CHECK_FALSE(closed({{1, 0}, {2, 0}, {2, 1}}));
    CHECK_FALSE(closed({{0, 0}, {2, 0}, {2, 1}}));
    // Rounding in the text of a scene does not open it.
    CHECK(closed({{0.1 + 0.2, 0}, {2, 0}, {2, 1}, {0.3, 0}}));
    // The ends of a cubic_spline only shape it.
    CHECK(Lathe{Spline::cubic, {{1, -9}, {0, 0}, {1, 0.5}, {0, 1}, {1, 9}}}.is_closed());
}

TEST_CASE("a spline makes a loop between two equal points", "[geom]") {
    // From (1, 0) to (1, 0): (1, 0) + u (1 - u) / 2 ((1 - u) (1, 1) + u (1, -1)), out to 1.125.
    const Lathe spindle{Spline::cubic, {{0, -2}, {0, -1}, {1, 0}, {1, 0}, {0, 1}, {0, 2}}};
    REQUIRE(spindle.is_closed());
    CHECK(spindle.bounds().high.x == Approx(1.125));
    CHECK(spindle.contains({1.12, 0.0, 0.0}));
    CHECK_FALSE(spindle.contains({1.13, 0.0, 0.0}));
    CHECK(spindle.contains({0.0, 0.0, 0.99}));
    CHECK_FALSE(spindle.contains({1.12, 0.05, 0.0}));
    const Crossings found = crossings_of(spindle, {{-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    REQUIRE(found.size() >= 2);
    CHECK(found[0].t == Approx(3.875));
    CHECK(found.back().t == Approx(6.125));
    // A quadratic spline goes out and comes back by the same way: nothing is inside.
    const Lathe spike{Spline::quadratic, {{0, -2}, {0, -1}, {1, 0}, {1, 0}, {0, 1}}};
    CHECK(spike.bounds().high.x == Approx(1.125));
    CHECK_FALSE(spike.contains({1.1, 0.1, 0.0}));
}

TEST_CASE("an open profile is met on both of its sides", "[geom]") {
    const Lathe funnel{Spline::linear, {{0.5, 0.0}, {1.0, 1.0}}};
    Crossings found;
    funnel.hits({{-5.0, 0.5, 0.0}, {1.0, 0.0, 0.0}}, found);
    REQUIRE(found.size() == 2);
    CHECK(found[0].t == Approx(4.25));
    CHECK(found[1].t == Approx(5.75));
    CHECK(found[0].entering != found[1].entering);
}

TEST_CASE("lines through the joints of a profile cross it an even number of times", "[geom]") {
    const Lathe vase{Spline::cubic,
                     {{0, -1},
                      {0, -1},
                      {0.6, -0.9},
                      {0.3, 0.0},
                      {0.7, 0.8},
                      {0.65, 0.85},
                      {0.2, 0.0},
                      {0.0, -0.5},
                      {0.0, -0.5}}};
    REQUIRE(vase.is_closed());
    Dice dice(2);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 joint = vase.points()[1 + dice.below(7)];
        const double angle = dice.between(0.0, 6.3);
        const Vec3 target{joint.x * std::cos(angle), joint.y, joint.x * std::sin(angle)};
        const Vec3 d = i % 3 == 0 ? Vec3{1.0, 0.0, 0.0} : dice.direction();
        const Crossings found = crossings_of(vase, {target - 3.0 * d, d});
        REQUIRE(found.size() % 2 == 0);
        for (std::size_t k = 1; k < found.size(); ++k) {
            if (found[k].t - found[k - 1].t < 1e-4) continue;
            const Vec3 middle = target + (0.49 * found[k].t + 0.51 * found[k - 1].t - 3.0) * d;
            REQUIRE(vase.contains(middle) == found[k - 1].entering);
        }
        for (const Crossing& crossing : found) {
            const Vec3 p = target + (crossing.t - 3.0) * d, n = vase.normal(crossing.face, p);
            if (glm::abs(glm::dot(n, d)) < 1e-2) continue;
            // What is just within is inside, what is just without is not.
            const bool within = vase.contains(p - 1e-7 * n), without = vase.contains(p + 1e-7 * n);
            const bool at_joint = glm::length(p - target) < 1e-4;
            if (!at_joint) REQUIRE((within && !without));
        }
    }
}

TEST_CASE("a line through the point of a lathe may pass it by and enter farther on", "[geom]") {
    // Its floor is y = r - r^2 / 3, whose point hangs down at the axis as a cone's does.
    const Lathe bowl{Spline::bezier,
                     {{0, 0},
                      {1, 1},
                      {2, 1},
                      {3, 0},
                      {3, 0},
                      {3, 1},
                      {3, 2},
                      {3, 3},
                      {3, 3},
                      {2, 3},
                      {1, 3},
                      {0, 3}}};
    Dice dice(1);
    for (int i = 0; i < 10000; ++i) {
        const double slope = dice.between(0.05, 0.95), angle = dice.between(0.0, 6.3);
        const Vec3 d = glm::normalize(Vec3{std::cos(angle), slope, std::sin(angle)});
        const double before = dice.between(0.1, 5.0);
        Crossings found = crossings_of(bowl, {-before * d, d});
        INFO("line " << i);
        // The point itself is touched or not.
        std::size_t first = 0;
        while (first < found.size() && glm::abs(found[first].t - before) < 1e-13) ++first;
        REQUIRE(first % 2 == 0);
        REQUIRE(found.size() == first + 2);
        const double per_radius = glm::sqrt(1.0 + slope * slope);
        CHECK(found[first].t - before == Approx(3.0 * (1.0 - slope) * per_radius).margin(1e-12));
        CHECK(found[first + 1].t - before == Approx(3.0 * per_radius).margin(1e-12));
    }
}

TEST_CASE("a lathe without a sensible profile says why", "[geom]") {
    CHECK_THROWS_WITH((Lathe{Spline::linear, {{1, 0}}}), Catch::Contains("at least two points"));
    CHECK_THROWS_WITH((Lathe{Spline::bezier, {{1, 0}, {1, 1}, {2, 2}}}),
                      Catch::Contains("four points"));
    CHECK_THROWS_WITH((Lathe{Spline::linear, {{-1, 0}, {1, 1}}}), Catch::Contains("negative"));
}

}  // namespace meniscus::geom
