#include "lanes/ray_stack.hpp"

#include <catch2/catch.hpp>

#include "lanes/stacks.hpp"

using namespace meniscus::lanes;

TEST_CASE("a stack of rays grows and keeps what it holds", "[lanes]") {
    RayStack stack;
    const std::size_t many = 3 * stack.capacity();
    for (std::size_t i = 0; i < many; ++i) {
        WaitingRay ray;
        ray.origin.x = double(i);
        ray.throughput.z = -double(i);
        ray.code = i;
        ray.birth_magnitude = 1.0 + double(i);
        ray.inside[1] = i << 20;
        stack.push(ray);
    }
    REQUIRE(stack.size() == many);
    for (std::size_t i = 0; i < many; ++i) {
        CHECK(stack[RayStack::ox][i] == double(i));
        CHECK(stack[RayStack::blue][i] == -double(i));
        CHECK((stack.word(RayStack::code)[i] & ~RayCode::birth_mask) == i);
        CHECK(RayCode::birth(stack.word(RayStack::code)[i]) >= 1.0 + double(i));
        CHECK(RayCode::birth(stack.word(RayStack::code)[i]) <= 1.01 * (1.0 + double(i)));
        CHECK(stack.word(RayStack::Field(RayStack::inside + 1))[i] == i << 20);
    }
}

TEST_CASE("rays wait by the strongest solid that they are in", "[lanes]") {
    Program program;
    for (const std::uint64_t places : {16, 8, 4 | 2, 1, 0}) {  // glass, ice, bubbles, water, open
        program.bins.emplace_back();
        program.bins.back().places[0] = places;
    }
    Stacks stacks(program);
    REQUIRE(stacks.bins.size() == 5);
    const auto bin_of = [&](std::uint64_t inside) { return &stacks.bin_of(Places{inside}); };
    CHECK(bin_of(16) == &stacks.bins[0]);
    CHECK(bin_of(1 | 2 | 8 | 16) == &stacks.bins[0]);
    CHECK(bin_of(1 | 8) == &stacks.bins[1]);
    CHECK(bin_of(1 | 2 | 4) == &stacks.bins[2]);
    CHECK(bin_of(4) == &stacks.bins[2]);
    CHECK(bin_of(1) == &stacks.bins[3]);
    CHECK(bin_of(0) == &stacks.in_the_open());

    stacks.bins[1].push({});
    CHECK(stacks.fullest() == 1);
    stacks.in_the_open().push({});
    stacks.in_the_open().push({});
    CHECK(stacks.fullest() == 4);
}
