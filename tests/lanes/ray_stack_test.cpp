#include "lanes/ray_stack.hpp"

#include <catch2/catch.hpp>
#include <set>

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

TEST_CASE("rays wait by what they are in", "[lanes]") {
    Program program;
    program.members.resize(5);  // water, two bubbles, ice, glass
    program.members[1].in_group = program.members[2].in_group = true;
    program.groups.resize(1);
    Stacks stacks(program);
    const auto bin_of = [&](std::uint64_t inside) { return &stacks.bin_of(Places{inside}); };
    CHECK(bin_of(0) == &stacks.in_the_open());
    CHECK(bin_of(1) == bin_of(2));
    CHECK(bin_of(1) == bin_of(1 | 2 | 4));
    CHECK(bin_of(8) == bin_of(1 | 8));
    CHECK(bin_of(16) == bin_of(1 | 2 | 8 | 16));
    const std::set<const RayStack*> different{bin_of(0), bin_of(1), bin_of(8), bin_of(16)};
    CHECK(different.size() == 4);

    stacks.bin_of(Places{8}).push({});
    CHECK(&stacks.fullest() == bin_of(8));
    stacks.in_the_open().push({});
    stacks.in_the_open().push({});
    CHECK(&stacks.fullest() == bin_of(0));
}

TEST_CASE("where small spheres are the strongest none hides them", "[lanes]") {
    Program program;
    program.members.resize(2);  // water, a bubble
    program.members[1].in_group = true;
    program.groups.resize(1);
    Stacks stacks(program);
    CHECK(stacks.bins.size() == 2);
    CHECK(&stacks.bin_of(Places{1}) == &stacks.bin_of(Places{2}));
}

TEST_CASE("without small spheres there are two bins", "[lanes]") {
    Program program;
    program.members.resize(2);
    Stacks stacks(program);
    CHECK(stacks.bins.size() == 2);
    CHECK(&stacks.bin_of(Places{1}) == &stacks.bin_of(Places{2}));
    CHECK(&stacks.bin_of(Places{1}) != &stacks.in_the_open());
}
