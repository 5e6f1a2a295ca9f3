#include "lanes/ray_stack.hpp"

#include <catch2/catch.hpp>

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
