#include "geom/mesh_search.hpp"

#include <hwy/targets.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "geom/bvh_builder.hpp"
#include "geom/triangle_mesh.hpp"
#include "tests/geom/lines.hpp"
#include "tests/geom/meshes.hpp"

namespace meniscus::geom {

namespace {

bool equal(const Crossings& a, const Crossings& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Crossing& x, const Crossing& y) {
                          return x.t == y.t && x.face == y.face && x.entering == y.entering;
                      });
}

int depth_behind(const Crossings& line, double t) {
    int depth = 0;
    for (const Crossing& crossing : line) {
        if (crossing.t > t) depth += crossing.entering ? -1 : 1;
    }
    return depth;
}

Crossings ahead_of(const Crossings& line, double from, double to, Face own) {
    Crossings ahead;
    for (const Crossing& crossing : line) {
        if (crossing.t > from && crossing.t <= to && crossing.face != own)
            ahead.push_back(crossing);
    }
    return ahead;
}

/// A ray from anywhere about a mesh of size 1, or from a face of it.
struct Start {
    Ray ray;
    Face own = no_face;
};

Start somewhere(const TriangleMesh& mesh, Dice& dice) {
    Start start{{dice.point(1.2), dice.direction()}};
    if (dice.below(2) == 0) return start;
    start.own = dice.below(static_cast<int>(mesh.size()));
    const auto [a, b, c] = mesh.corners(start.own);
    const double s = dice.between(0.05, 0.9), r = dice.between(0.05, 0.95 - s);
    start.ray.origin = a + s * (b - a) + r * (c - a);
    start.ray.origin_error = mesh.to_face(start.own, start.ray);
    return start;
}

TriangleMesh three_shells() {
    return TriangleMesh(joined(joined(icosphere(3), icosphere(2, 0.7)), torus_mesh(40, 20)));
}

}  // namespace

TEST_CASE("what lies ahead is what the whole line has there", "[geom]") {
    for (const TriangleMesh& mesh : {TriangleMesh(torus_mesh(60, 30)), three_shells()}) {
        Dice dice(21);
        int known = 0;
        for (int i = 0; i < 20000; ++i) {
            const auto [ray, own] = somewhere(mesh, dice);
            Crossings line, ahead;
            mesh.crossings(ray, line);
            Search search{.from = 0.0, .to = dice.between(0.1, 3.0), .own = own};
            // Where the origin is on a face, rounding alone says on which side of it.
            const double from = own == no_face ? 0.0 : 1e-12;
            const int depth = depth_behind(line, from);
            if (!mesh.crossings_ahead(ray, search, depth, ahead)) continue;
            ++known;
            REQUIRE(equal(ahead, ahead_of(line, from, search.to, own)));
        }
        // Within several shells the first crossing may well be a deeper one, which settles nothing.
        CHECK(known > (mesh.stats().components == 1 ? 19900 : 10000));
    }
}

TEST_CASE("a search ends a little behind the nearest crossing that matters", "[geom]") {
    const TriangleMesh mesh = three_shells();
    Dice dice(22);
    int ended = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto [ray, own] = somewhere(mesh, dice);
        Search search{.from = own == no_face ? 0.0 : 1e-12,
                      .entering_ends = dice.below(2) == 0,
                      .slack = dice.between(0.0, 0.1),
                      .slack_per_t = dice.between(0.0, 0.1),
                      .own = own};
        search.leaving_ends = !search.entering_ends;
        Crossings line, found;
        mesh.crossings(ray, line);
        double end = infinity;
        for (const Crossing& crossing : ahead_of(line, search.from, infinity, own)) {
            if (crossing.entering != search.entering_ends) continue;
            end = crossing.t + (search.slack + search.slack_per_t * crossing.t);
            break;
        }
        ended += end < infinity;
        mesh.crossings(ray, search, found);
        const Crossings expected = ahead_of(line, search.from, end, no_face);
        REQUIRE(found.size() == expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) REQUIRE(found[k].t == expected[k].t);
    }
    CHECK(ended > 5000);
}

TEST_CASE("a depth that the crossings contradict is not believed", "[geom]") {
    const TriangleMesh mesh(icosphere(2));
    Crossings found;
    const Ray from_within{{0.1, 0.2, 0.3}, {0.0, 0.0, 1.0}};
    CHECK(mesh.crossings_ahead(from_within, {.from = 0.0}, 1, found));
    CHECK(found.size() == 1);
    CHECK_FALSE(mesh.crossings_ahead(from_within, {.from = 0.0}, 0, found));
    const Ray away{{0.1, 0.2, 3.0}, {0.0, 0.0, 1.0}};
    found.clear();
    CHECK(mesh.crossings_ahead(away, {.from = 0.0}, 0, found));
    CHECK_FALSE(mesh.crossings_ahead(away, {.from = 0.0}, 1, found));
    // Up to a bound there may be nothing to leave yet.
    CHECK(mesh.crossings_ahead(from_within, {.from = 0.0, .to = 0.1}, 1, found));
}

TEST_CASE("searches in turns find what each finds alone, on every kind of processor", "[geom]") {
    const TriangleMesh meshes[] = {three_shells(),
                                   TriangleMesh(gridded_box(5, Vec3{-1.0}, Vec3{1.0}))};
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        Dice dice(24);
        for (int round = 0; round < 400; ++round) {
            const TriangleMesh& mesh = meshes[round % 2];
            std::vector<SearchedRay> rays(static_cast<std::size_t>(dice.below(40)));
            std::vector<Crossing> own_met(rays.size());
            const std::vector<Ray> awkward = awkward_lines(40, static_cast<unsigned>(round));
            for (std::size_t i = 0; i < rays.size(); ++i) {
                SearchedRay& one = rays[i];
                const auto [ray, own] = somewhere(mesh, dice);
                one.ray = dice.below(2) == 0 ? ray : awkward[i];
                one.search = {.from = dice.below(2) == 0 ? 0.0 : -infinity,
                              .to = dice.below(2) == 0 ? infinity : dice.between(0.1, 3.0),
                              .entering_ends = dice.below(2) == 0,
                              .leaving_ends = dice.below(2) == 0,
                              .slack = dice.between(0.0, 0.1),
                              .own = own,
                              .own_met = &own_met[i]};
                own_met[i].face = no_face;
            }
            mesh.crossings(rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const SearchedRay& one = rays[i];
                Crossing own{0.0, no_face, false};
                Search search = one.search;
                search.own_met = &own;
                Crossings alone;
                mesh.crossings(one.ray, search, alone);
                REQUIRE(equal(one.found, alone));
                // It is looked for only where it is: at the origin of a ray that was born there.
                if (own.face == no_face || std::abs(own.t) > 1e-9 || one.search.from < 0.0)
                    continue;
                REQUIRE(own_met[i].face == own.face);
                REQUIRE(own_met[i].t == own.t);
            }
        }
        hwy::SetSupportedTargetsForTest(0);
    }
}

TEST_CASE("every kind of processor finds the same crossings, to the bit", "[geom]") {
    const TriangleMesh meshes[] = {three_shells(),
                                   TriangleMesh(gridded_box(5, Vec3{-1.0}, Vec3{1.0}))};
    std::vector<Crossings> expected;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        std::size_t next = 0;
        for (const TriangleMesh& mesh : meshes) {
            for (const Ray& ray : awkward_lines(3000, 23)) {
                Crossings found;
                mesh.crossings(ray, found);
                if (next == expected.size()) expected.push_back(found);
                REQUIRE(equal(found, expected[next++]));
            }
        }
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST_CASE("corners that are floats are kept as floats, and the crossings are the same", "[geom]") {
    TriangleSoup soup = icosphere(4);
    for (Vec3& p : soup.positions) p = glm::round(p * 1048576.0) / 1048576.0;
    const TriangleMesh single(soup);
    CHECK(single.memory_bytes() < 60 * single.size());
    // One corner elsewhere that is no float: all of the mesh is kept in double.
    const TriangleMesh twofold(joined(soup, icosphere(0, 0.1, {50.1, 40.0, 30.0})));
    CHECK(twofold.memory_bytes() < 105 * twofold.size());
    CHECK(twofold.memory_bytes() > 72 * twofold.size());
    for (const Ray& ray : awkward_lines(3000, 24)) {
        Crossings a, b;
        single.crossings(ray, a);
        twofold.crossings(ray, {.from = -9.9, .to = 9.9}, b);
        Crossings near = ahead_of(a, -9.9, 9.9, no_face);
        REQUIRE(near.size() == b.size());
        for (std::size_t i = 0; i < b.size(); ++i) REQUIRE(near[i].t == b[i].t);
    }
}

TEST_CASE("any number of threads builds the same hierarchy", "[geom]") {
    Dice dice(25);
    std::vector<BuildItem> items;
    for (std::uint32_t i = 0; i < 40000; ++i) {
        const Vec3 p = dice.point(1.0);
        items.emplace_back(Bounds{p, p + Vec3{0.01}}, Vec3{0.0}, i);
    }
    const auto nodes_by = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<BuildItem> copy = items;
        return build_bvh(copy, 4);
    };
    const HugeVector<BvhNode> one = nodes_by(1), two = nodes_by(2);
    REQUIRE(one.size() == two.size());
    CHECK(std::memcmp(one.data(), two.data(), one.size() * sizeof(BvhNode)) == 0);
}

}  // namespace meniscus::geom
