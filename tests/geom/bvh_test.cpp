#include "geom/bvh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "geom/sphere.hpp"
#include "tests/geom/lines.hpp"

namespace meniscus::geom {

namespace {

std::vector<Sphere> scattered(int count, unsigned seed) {
    Dice dice(seed);
    std::vector<Sphere> spheres;
    for (int i = 0; i < count; ++i) spheres.push_back({dice.point(1.0), dice.between(0.01, 0.2)});
    return spheres;
}

Bvh over(const std::vector<Sphere>& spheres) {
    std::vector<Bounds> boxes;
    for (const Sphere& sphere : spheres) boxes.push_back(sphere.bounds());
    return Bvh(boxes);
}

}  // namespace

TEST_CASE("the hierarchy finds the nearest, as looking at everything does", "[geom]") {
    for (const int count : {1, 2, 5, 300}) {
        const std::vector<Sphere> spheres = scattered(count, 1);
        const Bvh bvh = over(spheres);
        for (const Ray& ray : awkward_lines(2000)) {
            double expected = infinity, nearest = infinity;
            for (const Sphere& sphere : spheres) {
                const Interval interval = sphere.interval(ray, no_face);
                if (interval.hit && interval.t0 > 0.0) expected = glm::min(expected, interval.t0);
            }
            bvh.traverse(ray, nearest, [&](std::uint32_t i) {
                const Interval interval = spheres[i].interval(ray, no_face);
                if (interval.hit && interval.t0 > 0.0) nearest = glm::min(nearest, interval.t0);
            });
            REQUIRE(nearest == expected);
        }
    }
}

TEST_CASE("the hierarchy visits all that a whole line meets", "[geom]") {
    const std::vector<Sphere> spheres = scattered(200, 2);
    const Bvh bvh = over(spheres);
    for (Ray ray : awkward_lines(2000)) {
        ray.origin = ray.at(3.0);  // among them
        std::vector<bool> visited(spheres.size());
        bvh.traverse_line(ray, [&](std::uint32_t i) { visited[i] = true; });
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            if (spheres[i].interval(ray, no_face).hit) REQUIRE(visited[i]);
        }
    }
}

TEST_CASE("the hierarchy misses nothing from far away, far out or in another scale", "[geom]") {
    Dice dice(5);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (const double offset : {0.0, 1e3, 1e6}) {
            std::vector<Sphere> spheres = scattered(100, 6);
            const Vec3 shift = offset * scale * Vec3{1.0, 0.7, -1.3};
            for (Sphere& sphere : spheres) {
                sphere = {shift + scale * sphere.center, scale * sphere.radius};
            }
            const Bvh bvh = over(spheres);
            for (int i = 0; i < 1000; ++i) {
                // Along silhouettes, from up to a million sizes away.
                const Sphere& aim = spheres[dice.below(100)];
                const Vec3 d = dice.direction(), side = glm::cross(d, dice.direction());
                const double away = scale * std::pow(10.0, dice.between(0.0, 6.0));
                const Vec3 limb = aim.center + (1.0 - 1e-9) * aim.radius * glm::normalize(side);
                const Ray ray{limb - away * d, d};
                std::vector<bool> visited(spheres.size());
                bvh.traverse(ray, infinity, [&](std::uint32_t k) { visited[k] = true; });
                for (std::size_t k = 0; k < spheres.size(); ++k) {
                    const Interval interval = spheres[k].interval(ray, no_face);
                    if (interval.hit && interval.t1 > 0.0) REQUIRE(visited[k]);
                }
            }
        }
    }
}

TEST_CASE("the hierarchy visits all boxes that overlap a region", "[geom]") {
    const std::vector<Sphere> spheres = scattered(200, 3);
    const Bvh bvh = over(spheres);
    for (const Sphere& region : scattered(100, 4)) {
        std::vector<int> visits(spheres.size());
        bvh.overlapping(region.bounds(), [&](std::uint32_t i) { ++visits[i]; });
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            REQUIRE(visits[i] <= 1);
            if (overlap(spheres[i].bounds(), region.bounds())) REQUIRE(visits[i] == 1);
        }
    }
}

TEST_CASE("ten thousand boxes in the same place make a hierarchy too", "[geom]") {
    const std::vector<Bounds> boxes(10000, Bounds{Vec3{0.0}, Vec3{1.0}});
    const Bvh bvh(boxes);
    int visits = 0;
    bvh.traverse_line({{0.5, 0.5, -3.0}, {0.0, 0.0, 1.0}}, [&](std::uint32_t) { ++visits; });
    CHECK(visits == 10000);
    CHECK(Bvh(std::vector<Bounds>{}).empty());
}

TEST_CASE("a line in the face of a box meets the box", "[geom]") {
    const Bounds box{Vec3{0.0}, Vec3{1.0}};
    for (const Vec3& d : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}}) {
        const Span span = span_inside(box, {0.5, 1.0, 1.0}, 1.0 / d);
        CHECK(span.near <= span.far);
        CHECK(span.near <= -0.5);
        CHECK(span.far >= 0.5);
    }
}

}  // namespace meniscus::geom
