#pragma once

#include <cstdint>

namespace meniscus::tracer {

/// A camera ray to be followed: through film point (x, y) in pixels from the top left.
struct Sample {
    double x, y;
    double weight = 1.0;
    std::uint64_t key = 0;     // what chance decides about it is a function of this
    std::uint32_t target = 0;  // where its light goes
};

}  // namespace meniscus::tracer
