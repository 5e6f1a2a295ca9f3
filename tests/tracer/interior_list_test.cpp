#include "tracer/interior_list.hpp"

#include <catch2/catch.hpp>

#include "tests/random/random.hpp"
#include "tests/tracer/scenes.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

/// Parts 0, 1, 2 of priorities 1, 2, 2.
tracer::RenderScene three() {
    scene::Scene scene;
    for (const double priority : {1.0, 2.0, 2.0}) add_glass(scene, geom::Sphere{}, 1.5, priority);
    return tracer::compile(std::move(scene));
}

}  // namespace

TEST_CASE("the highest priority is on top, whatever the order of entry", "[tracer]") {
    const auto scene = three();
    tracer::InteriorList list;
    CHECK(list.top(scene) == tracer::outside);
    list.enter(1);
    list.enter(0);
    CHECK(list.top(scene) == 1);
    list.leave(1);
    CHECK(list.top(scene) == 0);
    list.leave(0);
    CHECK(list.empty());
}

TEST_CASE("on a tie the solid entered last is on top", "[tracer]") {
    const auto scene = three();
    tracer::InteriorList list;
    list.enter(2);
    list.enter(1);
    CHECK(list.top(scene) == 1);
    list.leave(2);
    CHECK(list.top(scene) == 1);
    list.enter(2);
    CHECK(list.top(scene) == 2);
    list.leave(2);
    CHECK(list.top(scene) == 1);
}

TEST_CASE("a solid entered twice must be left twice", "[tracer]") {
    const auto scene = three();
    tracer::InteriorList list;
    list.enter(0);
    list.enter(0);
    list.leave(0);
    CHECK(list.inside(0));
    CHECK(list.top(scene) == 0);
    list.leave(0);
    CHECK_FALSE(list.inside(0));
    CHECK(list.empty());
}

TEST_CASE("the list has no fixed size", "[tracer]") {
    tracer::InteriorList list;
    for (int i = 0; i < 5000; ++i) list.enter(i);
    for (int i = 0; i < 5000; ++i) CHECK(list.inside(i));
    tracer::InteriorList copy = list;
    for (int i = 4999; i >= 0; --i) list.leave(i);
    CHECK(list.empty());
    CHECK(copy.depth(2500) == 1);
}

TEST_CASE("a long list is as right as a short one, and a copy keeps its own", "[tracer]") {
    scene::Scene source;
    for (int i = 0; i < 40; ++i) add_glass(source, geom::Sphere{}, 1.5, i % 7);
    const auto scene = tracer::compile(std::move(source));
    Random random(3);
    // The same by other means: who was entered how often, and when last.
    struct Plain {
        int depth[40] = {};
        int last[40] = {};
        int top() const {
            int best = tracer::outside;
            for (int i = 0; i < 40; ++i) {
                if (depth[i] <= 0) continue;
                if (best == tracer::outside || i % 7 > best % 7 ||
                    (i % 7 == best % 7 && last[i] > last[best]))
                    best = i;
            }
            return best;
        }
    };
    struct Pair {
        tracer::InteriorList list;
        Plain plain;
    };
    std::vector<Pair> pairs(8);
    for (int time = 1; time < 40000; ++time) {
        Pair& pair = pairs[std::size_t(random.below(8))];
        const int part = random.below(40);
        if (random.chance(0.2)) pair = pairs[std::size_t(random.below(8))];
        if (pair.plain.depth[part] <= random.below(2)) {
            pair.list.enter(part);
            ++pair.plain.depth[part];
            pair.plain.last[part] = time;
        } else {
            pair.list.leave(part);
            --pair.plain.depth[part];
        }
        if (random.chance(0.5)) REQUIRE(pair.list.top(scene) == pair.plain.top());
        if (time % 100 != 0) continue;
        for (const Pair& each : pairs) {
            REQUIRE(each.list.top(scene) == each.plain.top());
            for (int i = 0; i < 40; ++i) REQUIRE(each.list.depth(i) == each.plain.depth[i]);
        }
    }
}
