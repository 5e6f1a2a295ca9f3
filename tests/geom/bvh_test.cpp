#include "geom/bvh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

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
