// What the rays of a bin are not asked about they cannot come to before they leave the solid that
// they are in.

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "lang/interpret.hpp"
#include "tests/oracle/random_scene.hpp"
#include "tracer/lane_program.hpp"

using namespace meniscus;
using geom::Vec3;
using tracer::Part;

namespace {

using Indices = std::vector<int>;

lanes::Program program_of(const tracer::RenderScene& scene) {
    const auto made = tracer::make_lane_program(scene, {});
    REQUIRE(std::holds_alternative<lanes::Program>(made));
    return std::get<lanes::Program>(made);
}

tracer::RenderScene scene_of(const std::string& solids) {
    const std::string head =
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
        "camera { location <0, 1, -9> look_at <0, 1, 0> angle 40 }\n";
    return tracer::compile(lang::interpret_text("test.scene", head + solids).scene);
}

bool is_in(const lanes::Surroundings& bin, int rank) {
    return rank >= 0 && (bin.places[std::size_t(rank) / 64] >> (rank % 64) & 1u) != 0;
}

/// Random rays that start in what a bin is for.
class Walk {
public:
    Walk(const tracer::RenderScene& scene, const lanes::Program& program)
        : scene_(scene), program_(program), random_(7) {}

    int rays = 0, left_out = 0, missed = 0;

    void start(const lanes::Surroundings& bin, int trials) {
        const geom::Bounds around = scene_.bvh.bounds().padded(0.25 * scene_.size);
        for (int i = 0; i < trials; ++i) {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = around.low[axis] + uniform() * around.size()[axis];
            const int strongest = strongest_at(p);
            if (bin.is_open ? strongest >= 0 : !is_in(bin, strongest)) continue;
            follow(bin, strongest, p);
        }
    }

private:
    const Part& part(int rank) const {
        return scene_.parts[std::size_t(program_.members[std::size_t(rank)].part)];
    }
    double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

    int strongest_at(const Vec3& p) const {
        int rank = int(program_.members.size());
        while (--rank >= 0 && part(rank).shape.contains(p) == part(rank).inverse) {
        }
        return rank;
    }

    static double next(const Part& part, const geom::Ray& ray) {
        geom::Crossings crossings;
        part.shape.crossings(ray, crossings);
        double nearest = geom::infinity;
        for (const auto& crossing : crossings) {
            if (crossing.t > 0.0) nearest = std::min(nearest, crossing.t);
        }
        return nearest;
    }

    void follow(const lanes::Surroundings& bin, int strongest, const Vec3& p) {
        // The kernel takes rays of such a bin to be in no small sphere.
        for (const lanes::Member& member : program_.members) {
            if (member.in_group && !bin.small_spheres)
                missed += scene_.parts[std::size_t(member.part)].shape.contains(p);
        }
        geom::Ray ray;
        ray.origin = p;
        Vec3 d;
        do d = {uniform() - 0.5, uniform() - 0.5, uniform() - 0.5};
        while (glm::length(d) < 0.1);
        ray.direction = glm::normalize(d);
        double end = geom::infinity;
        for (int rank = 0; rank < int(program_.members.size()); ++rank) {
            if (bin.is_open || rank >= strongest) end = std::min(end, next(part(rank), ray));
        }
        ++rays;
        const auto look = [&](int index) {
            ++left_out;
            missed += next(scene_.parts[std::size_t(index)], ray) < end;
        };
        for (int i = 0; i < int(program_.solids.size()); ++i) {
            if (std::ranges::find(bin.all, i) == bin.all.end())
                look(program_.solids[std::size_t(i)].part);
        }
        for (const lanes::Member& member : program_.members) {
            if (member.in_group && !bin.small_spheres) look(member.part);
        }
    }

    const tracer::RenderScene& scene_;
    const lanes::Program& program_;
    std::mt19937_64 random_;
};

}  // namespace

TEST_CASE("of balls in balls a ray may come to the next ones alone", "[lanes]") {
    const auto scene = scene_of(
        "plane { y, 0 pigment { rgb 1 } }\n"
        "sphere { <0, 1.1, 0>, 1 material { ior 1.5 priority 1 } }\n"
        "sphere { <0, 1.1, 0>, 0.75 material { ior 1.3 priority 2 } }\n"
        "sphere { <0, 1.1, 0>, 0.5 material { ior 1.5 priority 3 } }\n");
    const auto program = program_of(scene);
    REQUIRE(program.bins.size() == 4);
    CHECK(program.bins[0].all == Indices{2});
    CHECK(program.bins[1].all == Indices{1, 2});
    CHECK(program.bins[2].all == Indices{0, 1});  // the floor is below it
    CHECK(program.bins[3].is_open);
    CHECK(program.bins[3].all == Indices{0, 3});
    CHECK(program.everything.all == Indices{0, 1, 2, 3});
}

TEST_CASE("balls of low priority inside of others are crossed unseen, and asked", "[lanes]") {
    const auto scene = scene_of(
        "sphere { <0, 1, 0>, 1 material { ior 1.5 priority 3 } }\n"
        "sphere { <0, 1, 0>, 0.75 material { ior 1.3 priority 2 } }\n"
        "sphere { <0, 1, 0>, 0.5 material { ior 1.5 priority 1 } }\n");
    const auto program = program_of(scene);
    REQUIRE(program.bins.size() == 4);
    CHECK(program.bins[0].all == Indices{0, 1, 2});  // solids stand by their ranks
    CHECK(program.bins[3].all == Indices{2});
}

TEST_CASE("a cup holds what is within its walls, and does not touch it", "[lanes]") {
    const std::string cup =
        "lathe { linear_spline 7, <0, 0>, <0.8, 0>, <0.8, 2>, <0.7, 2>, <0.7, 0.2>, <0, 0.2>, "
        "<0, 0> material { ior 1.5 priority 2 } }\n";
    const auto cube = [](const std::string& place) {
        return "box { -0.25, 0.25 rotate <17, 33, 11> translate " + place +
               " material { ior 1.31 priority 1 } }\n";
    };
    // The solids by their ranks: the cube, the cup.
    CHECK(program_of(scene_of(cup + cube("<0.1, 1, 0>"))).bins[0].all == Indices{1});
    CHECK(program_of(scene_of(cup + cube("<0.1, 3, 0>"))).bins[0].all == Indices{1});
    CHECK(program_of(scene_of(cup + cube("<0.4, 1, 0>"))).bins[0].all == Indices{0, 1});
    CHECK(program_of(scene_of(cup + cube("<0.1, 0.3, 0>"))).bins[0].all == Indices{0, 1});
    // Only in its own frame is it round.
    CHECK(program_of(scene_of("union {" + cup + "scale <1, 1, 0.5> }" + cube("<0.4, 1, 0>")))
              .bins[0]
              .all == Indices{0, 1});
}

TEST_CASE("the weakest of many solids share a bin", "[lanes]") {
    std::string boxes;
    for (int i = 0; i < 10; ++i) {
        boxes += "box { -0.9, 0.9 translate <" + std::to_string(2 * i) +
                 ", 0, 0> material { ior 1.5 priority " + std::to_string(i) + " } }\n";
    }
    const auto program = program_of(scene_of(boxes));
    REQUIRE(program.bins.size() == 8);
    CHECK(program.bins[0].all == Indices{9});
    CHECK(program.bins[5].all == Indices{4});
    CHECK(program.bins[6].all == Indices{0, 1, 2, 3});
    CHECK(program.bins[6].top == lanes::no_rank);
    CHECK(program.bins[7].all.size() == 10);
}

TEST_CASE("no ray comes to what its bin leaves out", "[lanes]") {
    int rays = 0, left_out = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        oracle::RandomSceneOptions options;
        options.fewest_solids = 4;
        options.most_solids = 12;
        options.cones = options.tori = options.lathes = true;
        options.scattered = seed % 2 == 0;
        options.rotated = seed % 3 == 0;
        options.stretched = seed % 5 == 0;
        options.unions = seed % 7 == 0;
        options.complements = seed % 11 == 0;
        options.scale = seed % 4 == 0 ? 1e-6 : 1.0;
        const auto scene = tracer::compile(oracle::random_scene(seed, options));
        const auto made = tracer::make_lane_program(scene, {});
        if (!std::holds_alternative<lanes::Program>(made)) continue;
        const auto& program = std::get<lanes::Program>(made);
        Walk walk(scene, program);
        for (const auto& bin : program.bins) walk.start(bin, 300);
        INFO("seed " << seed);
        CHECK(walk.missed == 0);
        rays += walk.rays;
        left_out += walk.left_out;
    }
    CHECK(rays > 50'000);
    CHECK(left_out > 20'000);
}

TEST_CASE("nor where many things are in a glass", "[lanes]") {
    std::string bubbles;
    for (int i = 0; i < 40; ++i) {
        const double turn = 2.4 * i;
        bubbles += "sphere { <" + std::to_string(0.5 * std::cos(turn)) + ", " +
                   std::to_string(0.35 + 0.02 * i) + ", " + std::to_string(0.5 * std::sin(turn)) +
                   ">, 0.03 material { ior 1 priority 3 } }\n";
    }
    const auto scene = scene_of(
        "plane { y, 0 pigment { rgb 1 } }\n"
        "lathe { linear_spline 7, <0, 0.01>, <0.8, 0.01>, <0.8, 2>, <0.7, 2>, <0.7, 0.2>, "
        "<0, 0.2>, <0, 0.01> material { ior 1.5 priority 5 } }\n"
        "cylinder { <0, 0.2, 0>, <0, 1.5, 0>, 0.7 material { ior 1.33 priority 1 } }\n"
        "box { -0.2, 0.2 rotate <17, 33, 11> translate <0.1, 1.45, 0> "
        "material { ior 1.31 priority 4 } }\n"
        "sphere { <0, 0.6, 0>, 0.2 pigment { rgb <1, 0, 0> } }\n" +
        bubbles);
    const auto program = program_of(scene);
    Walk walk(scene, program);
    for (const auto& bin : program.bins) walk.start(bin, 20'000);
    CHECK(walk.missed == 0);
    CHECK(walk.rays > 20'000);
    CHECK(walk.left_out > 20'000);
    REQUIRE(program.bins.size() == 5);  // glass, ice, all bubbles, water, the open
    // In the glass are no bubbles.
    CHECK_FALSE(program.bins.front().small_spheres);
    // The water can be met from above, the red ball and the bubbles only within it.
    CHECK_FALSE(program.bins.back().small_spheres);
}

TEST_CASE("what stands in a small sphere knows of it", "[lanes]") {
    std::string solids;
    for (int i = 0; i < 9; ++i) {
        const std::string at = "translate <" + std::to_string(2 * i) + ", 0, 0> ";
        solids += "sphere { 0, 0.9 " + at + "material { ior 1.5 priority 1 } }\n";
        if (i < 3) solids += "box { -0.3, 0.3 " + at + "material { ior 1.3 priority 2 } }\n";
    }
    const auto scene = scene_of(solids);
    const auto program = program_of(scene);
    REQUIRE_FALSE(program.groups.empty());
    Walk walk(scene, program);
    for (const auto& bin : program.bins) walk.start(bin, 20'000);
    CHECK(walk.missed == 0);
    CHECK(walk.rays > 5'000);
    CHECK(program.bins[0].small_spheres);
    CHECK_FALSE(program.bins.back().all.size() == program.solids.size());
}

TEST_CASE("where no solids meet none can hide another", "[lanes]") {
    const auto scene = scene_of(
        "sphere { <0, 1, 0>, 1 material { ior 1.5 priority 3 } }\n"
        "sphere { <3, 1, 0>, 1 material { ior 1.3 priority 2 } }\n"
        "sphere { <6, 1, 0>, 1 material { ior 1.5 priority 1 } }\n");
    const auto program = program_of(scene);
    for (const lanes::Member& member : program.members) CHECK(member.stronger == lanes::Places{});
    for (const auto& bin : program.bins) {
        for (const int i : bin.all) CHECK(bin.hiding[std::size_t(i)] == lanes::Hiding::never);
    }
}
